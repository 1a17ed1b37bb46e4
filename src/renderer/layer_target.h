/* A target for layers of a picture, drawn one after another and read into an image. */
#ifndef RENDERER_LAYER_TARGET_H
#define RENDERER_LAYER_TARGET_H

#include "base/image.h"
#include "gl/texture.h"

struct layer_target {
    struct texture texture; /* RGBA32F */
    GLuint framebuffer;
    int x, y; /* position of the image in the texture, y down; 0 initially */
};

/* Error: out of GPU memory. */
bool layer_target_init(struct layer_target *target, int width, int height);
void layer_target_free(struct layer_target *target);

/* Copies components first to first + count - 1 of the texture to the image's channels from
 * `channel` on. It flips rows: row 0 is the bottom in GL, the top in a file. */
void layer_target_read(const struct layer_target *target, int first, int count, struct image *image,
                       int channel);

#endif
