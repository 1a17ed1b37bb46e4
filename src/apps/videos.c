#include "apps/videos.h"

#include "apps/frames.h"
#include "base/error.h"
#include "base/file/output_file.h"

#include "parts.h"

void videos_take(struct videos *videos, struct text_list *outputs) {
    int kept = 0;
    for (int i = 0; i < outputs->count; i++) {
        const char *path = outputs->items[i];
        if (IF_VIDEO(video_file_is(path), false)) /* else a picture that nobody writes */
            videos->paths.items[videos->paths.count++] = path;
        else
            outputs->items[kept++] = path;
    }
    outputs->count = kept;
}

bool videos_check_use(const struct videos *videos, bool numbers, bool skips) {
    const struct text_list *paths = &videos->paths;
    for (int i = 0; i < paths->count; i++) {
        if (!numbers)
            return error_set("%s: a video needs --frames A..B", paths->items[i]);
        if (frame_name_is_numbered(paths->items[i]))
            return frame_name_refuse(paths->items[i], "a video has all frames");
        if (skips)
            return error_set("%s: a video is made of all frames, and --skip-existing leaves some "
                             "out; write numbered pictures: -o frame.####.png",
                             paths->items[i]);
    }
    return true;
}

bool videos_check(const struct videos *videos) {
    bool ok = true;
    for (int i = 0; ok && i < videos->paths.count; i++)
        ok = IF_VIDEO(video_file_check(videos->paths.items[i]), false) &&
             output_file_check(videos->paths.items[i], NULL, 0);
    return ok;
}

bool videos_begin(struct videos *videos, int width, int height, const char *rate) {
    bool ok = true;
    while (ok && videos->begun < videos->paths.count) {
        struct video_file *file = &videos->files[videos->begun];
        const char *path = videos->paths.items[videos->begun++];
        (void)file, (void)path, (void)width, (void)height, (void)rate;
        ok = IF_VIDEO(video_file_begin(file, path, width, height, rate), false);
    }
    return ok;
}

bool videos_add(struct videos *videos, const struct bitmap *frame) {
    bool ok = true;
    (void)frame;
    for (int i = 0; ok && i < videos->begun; i++)
        ok = IF_VIDEO(video_file_add(&videos->files[i], frame), false);
    return ok;
}

bool videos_end(struct videos *videos, bool ok) {
    bool all = true;
    for (int i = 0; i < videos->begun; i++)
        all = IF_VIDEO(video_file_end(&videos->files[i], ok && all), ok) && all;
    videos->begun = 0;
    return all;
}
