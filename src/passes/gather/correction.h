/* Visibility correction: a few rays correct the lookups in VALs' maps.
 *
 * A VAL's map lets light through beside ledges that hide a part of the scene from it, and blocks some light that passes
 * behind what it sees. The error is alike over wide parts of the picture. A test takes one of sixteen VPLs by its light
 * at a pixel [Talbot et al. 2005] and looks it up by map and by block, and by a ray through the scene's triangles.
 * The tests give a correction for each VAL and each part of the picture. Where lookups let through too much light, the
 * correction takes off a fraction; where they block too much, it lets a fraction through: visibility stays between 0
 * and 1. Corrections are shrunk towards those of the whole picture and of all VALs by their variance [James and
 * Stein 1961].
 *
 * Cost: as many rays and lookups as tests; a fetch beside each lookup of a pixel. init_set of techniques/vals.c decides
 * whether it runs.
 */
#ifndef PASSES_CORRECTION_H
#define PASSES_CORRECTION_H

#include "passes/visibility/visibility.h"

struct block_visibilities;
struct frame;
struct gbuffer;
struct vpl_buffer;

struct correction_desc {
    int vpl_count, tests;
    int clamp;                         /* GATHER_CLAMP_..., one without parameters */
    struct visibility_desc visibility; /* of pixels that look themselves up */
};

struct correction_pass {
    struct correction_desc desc;
    GLuint test_program, sum_program, val_program, mean_program, cell_program, block_program;
    struct texture tests;                 /* RGBA32F: glsl/gather/correction_test.frag */
    struct texture sums;                  /* RGBA32F, CORRECTION_SIDE cells a side, a layer a VAL */
    struct texture squares;               /* RG32F, likewise */
    struct texture val_sums, val_squares; /* the same of all cells, a texel a VAL */
    struct texture mean;                  /* RG32F, one texel: corrections of all VALs together */
    struct texture corrections;           /* RG16F, likewise: glsl/gather/correction.glsl */
    GLuint test_framebuffer, sum_framebuffer, val_framebuffer, mean_framebuffer, cell_framebuffer;
    struct buffer params, lookup_params;
};

bool correction_pass_init(struct correction_pass *pass, const struct correction_desc *desc);
void correction_pass_free(struct correction_pass *pass);

/* Fills pass->corrections, and corrects the blocks by them, where there are any: NULL. Timer "correction". */
void correction_pass_render(const struct correction_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct vpl_buffer *vpls,
                            const struct visibility_inputs *inputs,
                            const struct block_visibilities *blocks);

#endif
