#include "apps/videos.h"

#include "base/file/output_file.h"

#include "parts.h"

/* NULL: names of videos are those of pictures that nobody writes. */
static const struct video_files *const encoders = IF_VIDEO(&video_files);

void videos_take(struct videos *videos, struct text_list *outputs) {
    int kept = 0;
    for (int i = 0; i < outputs->count; i++) {
        const char *path = outputs->items[i];
        if (encoders && encoders->has_extension(path))
            videos->paths.items[videos->paths.count++] = path;
        else
            outputs->items[kept++] = path;
    }
    outputs->count = kept;
}

bool videos_check(const struct videos *videos) {
    bool ok = true;
    for (int i = 0; ok && i < videos->paths.count; i++)
        ok = encoders->check(videos->paths.items[i]) &&
             output_file_check(videos->paths.items[i], NULL, 0);
    return ok;
}

bool videos_begin(struct videos *videos, int width, int height, const char *rate) {
    bool ok = true;
    while (ok && videos->begun < videos->paths.count) {
        int i = videos->begun++;
        ok = encoders->begin(&videos->files[i], videos->paths.items[i], width, height, rate);
    }
    return ok;
}

bool videos_add(struct videos *videos, const struct bitmap *frame) {
    bool ok = true;
    for (int i = 0; ok && i < videos->begun; i++)
        ok = encoders->add(&videos->files[i], frame);
    return ok;
}

bool videos_end(struct videos *videos, bool ok) {
    bool all = true;
    for (int i = 0; i < videos->begun; i++)
        all = encoders->end(&videos->files[i], ok && all) && all;
    videos->begun = 0;
    return all;
}
