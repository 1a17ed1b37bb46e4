/* Masks of pixels: one screen pass marks them, another runs at them (gl/screen.h).
 *
 * Drawn passes use a depth texture that is 0 at marked pixels, else 1. The depth test skips the
 * other pixels; a branch in the shader would not, because a software rasteriser executes both
 * sides. Dispatched passes use a queue of the marked pixels and an indirect dispatch over it, so
 * workgroups are full. */
#ifndef GL_PIXEL_MASK_H
#define GL_PIXEL_MASK_H

#include "gl/buffer.h"
#include "gl/texture.h"

struct pixel_mask {
    struct texture depth; /* D16, for drawn passes: depth attachment of their framebuffers */
    GLuint framebuffer;   /* for the drawn pass that marks */
    struct buffer queue;  /* for dispatched passes: gl/screen_glsl.c */
};

/* Creates the depth texture or the queue, depending on screen_way. Error: out of GPU memory. */
bool pixel_mask_init(struct pixel_mask *mask, const char *label, int width, int height);
void pixel_mask_free(struct pixel_mask *mask);

/* Unmarks all pixels. */
void pixel_mask_clear(const struct pixel_mask *mask);

/* Returns the depth texture for the framebuffer of the pass that runs at marked pixels; NULL if
 * passes are dispatched. */
const struct texture *pixel_mask_depth(const struct pixel_mask *mask);

#endif
