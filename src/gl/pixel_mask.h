/* Some pixels of a picture, which one screen pass marks and another runs at (gl/screen.h).
 *
 * Drawn passes have a depth texture: 0 at a marked pixel, else 1. The depth test then leaves out the others, as a branch
 * in a shader would not: a software rasteriser executes both sides. Dispatched passes have a queue of the marked
 * pixels, and an indirect dispatch over it: so groups of invocations are full.
 */
#ifndef GL_PIXEL_MASK_H
#define GL_PIXEL_MASK_H

#include "gl/buffer.h"
#include "gl/texture.h"

struct pixel_mask {
    struct texture depth; /* D16, of drawn passes; the depth of their framebuffers */
    GLuint framebuffer;   /* of the pass that marks, drawn */
    struct buffer queue;  /* of dispatched passes: gl/screen_glsl.c */
};

/* For how screen passes run. Error: out of GPU memory. */
bool pixel_mask_init(struct pixel_mask *mask, const char *label, int width, int height);
void pixel_mask_free(struct pixel_mask *mask);

/* No pixel is marked. */
void pixel_mask_clear(const struct pixel_mask *mask);

/* The depth texture, or NULL: for the framebuffer of the pass that runs at marked pixels. */
const struct texture *pixel_mask_depth(const struct pixel_mask *mask);

#endif
