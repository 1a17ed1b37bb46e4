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

#include "passes/targets.h"
#include "passes/visibility/visibility.h"
#include "shared/gather.h"

struct frame;
struct gbuffer;

struct gather_desc {
    int width, height;
    int interleave;   /* n; 1 = all VPLs at each pixel */
    bool map_per_vpl; /* map i - first of the draw belongs to VPL i; else map C(i) */
    bool share;       /* visibility comes by blocks */
    bool cuts; /* each pixel takes its block's cut; a slot is a set of pixels (struct vpl_tree) */
    int together; /* so many lights side by side, of which two test the visibility of all; 0: each asks */
    int receivers; /* RECEIVERS_ADAPTIVE: pixels of lists, whose pattern is interleave */
    int list_slots
        [LIST_KINDS]; /* of those: of the pattern's slots, as many side by side as what is on
                                   the list takes; 0: it does not gather */
    struct visibility_desc visibility;
    int clamp;         /* GATHER_CLAMP_... */
    float sphere;      /* radius of balls, over the distance within which ten VPLs lie */
    float clamp_value; /* of the bounded geometry term, times the squared scene radius */
    bool lobes;        /* VPLs of the first bounce mirror light by lobes */
    bool medium;       /* frames have one */
    bool later;        /* VPLs of later bounces come too */
    int specular; /* SPECULAR_...: radiance towards the eye in irradiance's place, of a G-buffer
                          with a specular target */
    int specular_rays; /* of SPECULAR_RAYS: of each pixel */
};

struct gather_pass {
    struct gather_desc desc;
    GLuint program, later_program;
    struct irradiance irradiance;
    struct buffer params, lookup_params;
};

bool gather_pass_init(struct gather_pass *pass, const struct gather_desc *desc);
void gather_pass_free(struct gather_pass *pass);

/* Zeroes the sum. */
void gather_pass_clear(const struct gather_pass *pass);

/* What a gather reads beside the G-buffer. */
struct gather_inputs {
    const struct vpl_buffer *vpls;
    int first, count; /* of the VPLs; all of them where count is 0 */
    bool
        later; /* they are of later bounces, and no near field is theirs: bounded as patches, unless
                     they are rectangles */
    const struct texture *kept;              /* of patches: what they keep of light, a pixel */
    const struct buffer *rectangles;         /* of the lights, with GATHER_CLAMP_RECTANGLE */
    struct visibility_inputs visibility;     /* unless VISIBILITY_LOOKUP_NONE */
    const struct block_visibilities *blocks; /* where desc.share */
    const struct vpl_cuts *cuts;             /* where desc.cuts */
    const struct pixel_lists *lists;         /* unless desc.receivers is RECEIVERS_ALL */
};

/* Fills pass->params, for others who take light as it does (passes/gather/geometry_term.glsl). */
void gather_pass_write_params(const struct gather_pass *pass, const struct frame *frame,
                              const struct gather_inputs *inputs);

/* Adds the VPLs' light to pass->irradiance. Timer "gather", "adaptive gather" or
 * "gather, specular". */
void gather_pass_render(const struct gather_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs);

#endif
