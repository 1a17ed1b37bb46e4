/* Finds the pixels that a blur cannot help: those with few like neighbours, as on leaves and
 * mouldings. They gather more lights, and are blurred less: the fewer neighbours are like, the more.
 *
 * Such pixels lie scattered, and a software rasteriser (as a wave of a GPU) takes as long for one of
 * eight neighbours as for all: so they are listed, and drawn side by side.
 */
#ifndef PASSES_DETAIL_H
#define PASSES_DETAIL_H

#include "passes/lists.h"

struct frame;
struct gbuffer;

struct detail_desc {
    int width, height;
    int interleave; /* n of the lists' pattern, at most 8 */
    int radius;     /* of the four neighbours that are asked, pixels along x and y */
    float distance; /* as in struct blur_desc */
    float cosine;
    float share; /* of like neighbours, below which a pixel is listed */
    /* At most cosine. What lies between is gentle relief, which has neighbours that are unlike on all sides, and needs
     * no more than an edge does: it makes no PIXEL_GRADE_DETAIL. */
    float sharp_cosine;
    int block; /* pixels a side of a block that shares its visibility; pixels without one are listed; 0: none does */
};

struct detail_pass {
    struct detail_desc desc;
    GLuint program;
    GLuint framebuffer; /* of list texels */
    struct pixel_lists lists;
    struct buffer params;
};

bool detail_pass_init(struct detail_pass *pass, const struct detail_desc *desc);
void detail_pass_free(struct detail_pass *pass);

/* Fills pass->lists. Timer "detail". */
void detail_pass_render(const struct detail_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer);

#endif
