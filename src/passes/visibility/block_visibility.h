/* Tests visibility once per VAL and block of pixels. Soft shadows of area lights are smooth, so one
 * lookup serves a block. The gather takes the nearest block on the same surface and tests its own
 * visibility without one. With 7 x 7 blocks 30 lookups replace 784 per 49 pixels. */
#ifndef PASSES_BLOCK_VISIBILITY_H
#define PASSES_BLOCK_VISIBILITY_H

#include "passes/maps.h"
#include "passes/visibility/visibility.h"

struct frame;
struct gbuffer;

struct block_visibility_desc {
    int width, height; /* of the picture */
    int block;         /* side of a block, pixels */
    struct visibility_desc visibility;
};

struct block_visibility_pass {
    struct block_visibility_desc desc;
    GLuint program;
    struct block_visibilities blocks;
    struct buffer params, lookup_params;
};

bool block_visibility_pass_init(struct block_visibility_pass *pass,
                                const struct block_visibility_desc *desc);
void block_visibility_pass_free(struct block_visibility_pass *pass);

/* Fills pass->blocks. Timer "block visibility". */
void block_visibility_pass_render(const struct block_visibility_pass *pass,
                                  const struct frame *frame, const struct gbuffer *gbuffer,
                                  const struct visibility_inputs *inputs);

#endif
