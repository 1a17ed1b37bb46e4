/* Gathers irradiance from all VPLs, interleaved [Dong 2009 §6; Segovia et al. 2006].
 *
 *     E(x) = n^2 sum_{i in slot(x)} Phi_i / pi  cos_i cos_x / d^2  V_C(i)(x)
 *
 * Each pixel of an n x n block takes 1 / n^2 of the VPLs. Pixels of one slot are drawn together as
 * a tile and read the same VPLs and maps. Cost: pixels x N / n^2 lookups. */
#ifndef PASSES_GATHER_H
#define PASSES_GATHER_H

#include "passes/targets.h"
#include "passes/visibility/visibility.h"
#include "shared/gather.h"

struct frame;
struct gbuffer;

struct gather_desc {
    int width, height;
    int interleave;   /* n; 1: all VPLs at each pixel */
    bool map_per_vpl; /* VPL i uses map i - first of the draw; else map C(i) */
    bool share;       /* reads visibility of blocks */
    /* Each pixel takes the cut of its block; a slot is a set of pixels (struct vpl_tree). */
    bool cuts;
    /* VPLs side by side of which two test visibility for all. 0: each VPL tests its own. */
    int together;
    /* RECEIVERS_...; RECEIVERS_ADAPTIVE: pixels of lists with pattern `interleave`. */
    int receivers;
    /* Number of adjacent slots that one entry of each list gathers. 0: the list does not gather. */
    int list_slots[LIST_KINDS];
    struct visibility_desc visibility;
    int clamp;         /* GATHER_CLAMP_... */
    float sphere;      /* radius of a VPL's ball, over the radius within which ten VPLs are */
    float clamp_value; /* bound of the geometry term, times the squared scene radius */
    bool lobes;        /* VPLs of the first bounce have specular lobes */
    bool medium;       /* frames have a medium */
    bool later;        /* also gathers VPLs of later bounces */
    /* SPECULAR_...: gathers radiance towards the camera in place of irradiance. It needs a G-buffer
     * with a specular target. */
    int specular;
    int specular_rays; /* rays of a pixel, for SPECULAR_RAYS */
};

struct gather_pass {
    struct gather_desc desc;
    GLuint program, later_program;
    struct irradiance irradiance;
    struct buffer params, lookup_params;
};

bool gather_pass_init(struct gather_pass *pass, const struct gather_desc *desc);
void gather_pass_free(struct gather_pass *pass);

/* Clears pass->irradiance. */
void gather_pass_clear(const struct gather_pass *pass);

/* Inputs besides the G-buffer. */
struct gather_inputs {
    const struct vpl_buffer *vpls;
    int first, count; /* range of VPLs; count 0: all */
    /* VPLs of later bounces: without near field, and bounded as patches unless they are
     * rectangles. */
    bool later;
    const struct texture *kept;      /* fraction of light that patches retain, one texel a pixel */
    const struct buffer *rectangles; /* rectangles of the lights, for GATHER_CLAMP_RECTANGLE */
    struct visibility_inputs visibility;     /* required unless VISIBILITY_LOOKUP_NONE */
    const struct block_visibilities *blocks; /* required with desc.share */
    const struct vpl_cuts *cuts;             /* required with desc.cuts */
    const struct pixel_lists *lists;         /* required unless desc.receivers is RECEIVERS_ALL */
};

/* Writes pass->params, for other passes that use passes/gather/geometry_term.glsl. */
void gather_pass_write_params(const struct gather_pass *pass, const struct frame *frame,
                              const struct gather_inputs *inputs);

/* Adds the VPLs' light to pass->irradiance. Timer "gather", "adaptive gather" or "gather,
 * specular". */
void gather_pass_render(const struct gather_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs);

#endif
