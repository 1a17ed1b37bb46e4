/* Finds the pixels that a blur cannot help: those with few like neighbours, as on leaves and
 * mouldings. They gather more lights, and are blurred less: the fewer neighbours are like, the more.
 *
 * Such pixels lie scattered, and a software rasteriser (as a wave of a GPU) takes as long for one of
 * eight neighbours as for all: so lists hold them, and they are drawn side by side.
 */
#ifndef PASSES_ADAPTIVE_H
#define PASSES_ADAPTIVE_H

#include "passes/lists.h"

struct frame;
struct gbuffer;

struct adaptive_desc {
    int width, height;
    int interleave; /* n of the lists' pattern, at most 8 */
    int radius;     /* of the four neighbours that are asked, pixels along x and y */
    float distance; /* as in struct blur_desc */
    float cosine;
    float share; /* of like neighbours, below which a pixel is adaptive */
    /* At most cosine. What lies between is gentle relief, which has neighbours that are unlike on all sides, and needs
     * no more than an edge does: it makes no PIXEL_LEVEL_DETAIL. */
    float sharp_cosine;
    int block; /* pixels a side of a block that shares its visibility; pixels without one are adaptive; 0: none does */
};

struct adaptive_pass {
    struct adaptive_desc desc;
    GLuint program;
    GLuint framebuffer; /* of list texels */
    struct pixel_lists lists;
    struct buffer params;
};

bool adaptive_pass_init(struct adaptive_pass *pass, const struct adaptive_desc *desc);
void adaptive_pass_free(struct adaptive_pass *pass);

/* Fills pass->lists. Timer "adaptive". */
void adaptive_pass_render(const struct adaptive_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer);

#endif
