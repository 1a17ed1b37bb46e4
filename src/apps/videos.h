/* Outputs of render that are videos, beside its pictures. */
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

/* Takes the names of videos out of the outputs. */
void videos_take(struct videos *videos, struct text_list *outputs);

/* Whether they go with --frames and --skip-existing, by whether these are given. Error: an
 * option's. */
bool videos_check_use(const struct videos *videos, bool numbers, bool skips);

/* Whether each can be written. Error: names the path and the reason. */
bool videos_check(const struct videos *videos);

/* Error: video_file_begin's and video_file_add's; videos_end is then to be called. */
bool videos_begin(struct videos *videos, int width, int height, const char *rate);
bool videos_add(struct videos *videos, const struct bitmap *frame);

/* ok false: no video is kept, and no new error set. */
bool videos_end(struct videos *videos, bool ok);

#endif
