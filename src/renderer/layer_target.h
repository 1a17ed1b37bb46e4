/* Where layers of a picture are drawn, one after another, to be read into an image. */
#ifndef RENDERER_LAYER_TARGET_H
#define RENDERER_LAYER_TARGET_H

#include "base/image.h"
#include "gl/texture.h"

struct layer_target {
    struct texture texture; /* RGBA32F */
    GLuint framebuffer;
    int x, y; /* where the image lies in it, y down: 0 at first */
};

/* Error: out of GPU memory. */
bool layer_target_init(struct layer_target *target, int width, int height);
void layer_target_free(struct layer_target *target);

/* Copies components [first, first + count) of what is drawn to the image's channels from `channel`
 * on. GL's row 0 is at the bottom, a file's at the top. */
void layer_target_read(const struct layer_target *target, int first, int count, struct image *image,
                       int channel);

#endif
