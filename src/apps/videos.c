#include "apps/videos.h"

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
