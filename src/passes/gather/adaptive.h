/* Lists adaptive pixels: pixels with few similar neighbours, for example on leaves and mouldings.
 * They gather more lights and get a smaller blur.
 *
 * Adaptive pixels are scattered, and a SIMD group takes as long for one pixel as for all its lanes.
 * Lists let a pass draw them side by side. */
#ifndef PASSES_ADAPTIVE_H
#define PASSES_ADAPTIVE_H

#include "passes/lists.h"

struct frame;
struct gbuffer;

struct adaptive_desc {
    int width, height;
    int interleave; /* n of the lists' pattern, at most 8 */
    int radius;     /* distance to the four diagonal neighbours, pixels along x and y */
    float distance; /* as in struct blur_desc */
    float cosine;
    float share; /* fraction of similar neighbours below which a pixel is adaptive */
    /* At most `cosine`. Angles between both are gentle relief, which needs the level of an edge and
     * not PIXEL_LEVEL_DETAIL. */
    float sharp_cosine;
    /* Side of a visibility block, pixels. A pixel without a matching block is adaptive. 0: no
     * blocks. */
    int block;
};

struct adaptive_pass {
    struct adaptive_desc desc;
    GLuint program;
    GLuint framebuffer; /* target for list texels */
    struct pixel_lists lists;
    struct buffer params;
};

bool adaptive_pass_init(struct adaptive_pass *pass, const struct adaptive_desc *desc);
void adaptive_pass_free(struct adaptive_pass *pass);

/* Fills pass->lists. Timer "adaptive". */
void adaptive_pass_render(const struct adaptive_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer);

#endif
