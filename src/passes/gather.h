/* Irradiance from all VPLs, interleaved [Dong 2009 §6; Segovia et al. 2006].
 *
 *     E(x) = n^2 sum_{i in slot(x)} Phi_i / pi  cos_i cos_x / d^2  V_C(i)(x)
 *
 * In n x n blocks of pixels each pixel takes one n^2-th of the VPLs; pixels of the same slot are
 * drawn together as a tile, so that they read the same VPLs and the same maps. Cost: pixels x N /
 * n^2 lookups.
 */
#ifndef PASSES_GATHER_H
#define PASSES_GATHER_H

#include "passes/frame.h"

enum gather_visibility { GATHER_VISIBILITY_NONE, GATHER_VISIBILITY_HARD, GATHER_VISIBILITY_CSSM };

/* How cos cos / d^2 is bounded near a VPL. The disk form factor is that of a disk of the VPL's
 * area. GATHER_CLAMP_NEAR leaves the near field to passes/near_field.h. */
enum gather_clamp { GATHER_CLAMP_NONE, GATHER_CLAMP_VALUE, GATHER_CLAMP_DISK, GATHER_CLAMP_NEAR };

struct gather_desc {
    int width, height;
    int interleave; /* n; 1 = all VPLs at each pixel */
    enum gather_visibility visibility;
    bool map_per_vpl; /* map i - first_map of the draw belongs to VPL i; else map C(i) */
    int map_size, map_count, basis_terms;
    enum gather_clamp clamp;
    float clamp_value;          /* of the bounded geometry term, times the squared scene radius */
    float reach;                /* of the near field, in spacings of VPLs */
    float bias;                 /* receiver offset along its normal, over the scene's radius */
    float map_bias;             /* of a hard lookup, over the scene's radius */
    float shift;                /* of the receiver's depth, over 1 / (2 K) */
    float gain;                 /* of the blocked fraction about one half */
    float sharpen_a, sharpen_b; /* thesis eq. 5.9; A = 0: off */
    bool filter_jacobian;       /* exact paraboloid Jacobian in place of alpha / pi */
};

struct gather_pass {
    struct gather_desc desc;
    GLuint program;
    struct irradiance irradiance;
    struct buffer params;
};

bool gather_pass_init(struct gather_pass *pass, const struct gather_desc *desc);
void gather_pass_free(struct gather_pass *pass);

/* Zeroes the sum. */
void gather_pass_clear(const struct gather_pass *pass);

/* What a gather reads beside the G-buffer. */
struct gather_inputs {
    const struct vpl_buffer *vpls;
    int first, count;               /* of the VPLs; all of them where count is 0 */
    const struct map_views *views;  /* unless GATHER_VISIBILITY_NONE */
    const struct depth_maps *depth; /* GATHER_VISIBILITY_HARD */
    const struct basis_maps *bases; /* GATHER_VISIBILITY_CSSM */
};

/* Adds the VPLs' light to pass->irradiance. Timer "gather". */
void gather_pass_render(const struct gather_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs);

#endif
