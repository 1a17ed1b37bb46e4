/* Maps calibrated by rays: how much light of each VAL arrives in each part of the picture by lookups, and how much by rays
 * through the scene's triangles. Lookups are then corrected so that in sum as much arrives.
 *
 * A VAL's map lets light through beside ledges that it does not see behind, and stops some that passes behind what it sees. What
 * it errs by is alike over wide parts of the picture, so that a few rays tell. A test takes one of sixteen VPLs by what
 * they give to a pixel [Talbot et al. 2005], and asks for it by map, by block and by ray. Of what maps let through too much
 * a part is taken off; of what they stop too much a part is let through: visibility stays between 0 and 1. What a part of
 * the picture differs from all of it by, and a VAL from all VALs, counts for less where chance may be all of it
 * [James and Stein 1961].
 *
 * Cost: so many rays and lookups; a fetch beside each lookup of a pixel.
 */
#ifndef PASSES_CALIBRATION_H
#define PASSES_CALIBRATION_H

#include "passes/visibility/visibility.h"

struct block_visibilities;
struct frame;
struct gbuffer;
struct vpl_buffer;

struct calibration_desc {
    int vpl_count, tests;
    int clamp; /* CLAMP of gather/geometry_term.glsl: one without parameters */
    struct visibility_desc visibility; /* of pixels that look themselves up */
};

struct calibration_pass {
    struct calibration_desc desc;
    GLuint test_program, sum_program, mean_program, gain_program, block_program;
    struct texture tests;   /* RGBA32F: glsl/gather/calibration_test.frag */
    struct texture sums;    /* RGBA32F, CALIBRATION_SIDE cells a side, a layer a VAL */
    struct texture squares; /* RG32F, likewise */
    struct texture mean;    /* RG32F, one texel: gains of all VALs together */
    struct texture gains;   /* RG16F, likewise: glsl/gather/calibration.glsl */
    GLuint test_framebuffer, sum_framebuffer, mean_framebuffer, gain_framebuffer;
    struct buffer params, lookup_params;
};

bool calibration_pass_init(struct calibration_pass *pass, const struct calibration_desc *desc);
void calibration_pass_free(struct calibration_pass *pass);

/* Fills pass->gains, and corrects the blocks by them, where there are any: NULL. Timer "calibration". */
void calibration_pass_render(const struct calibration_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer, const struct vpl_buffer *vpls,
                             const struct visibility_inputs *inputs,
                             const struct block_visibilities *blocks);

#endif
