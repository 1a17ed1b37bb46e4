/* Writes outputs of `render` that are videos. */
#ifndef APPS_VIDEOS_H
#define APPS_VIDEOS_H

#include "base/file/video_file.h"
#include "base/option.h"

/* Zeroed: none. */
struct videos {
    struct text_list paths;
    struct video_file files[TEXT_LIST_MAX]; /* of the first `begun` paths */
    int begun;
};

/* Moves the paths of videos from `outputs` to `videos`. */
void videos_take(struct videos *videos, struct text_list *outputs);

/* Checks that videos have --frames and no --skip-existing, given as flags. Error: names the
 * option. */
bool videos_check_use(const struct videos *videos, bool numbers, bool skips);

/* Checks that each path can be written. Error: names the path and the reason. */
bool videos_check(const struct videos *videos);

/* Begin all videos, and add a frame to each. Error: of video_file_begin and video_file_add; the
 * caller must then call videos_end. */
bool videos_begin(struct videos *videos, int width, int height, const char *rate);
bool videos_add(struct videos *videos, const struct bitmap *frame);

/* Ends all videos. ok false: removes them and sets no new error. */
bool videos_end(struct videos *videos, bool ok);

#endif
