/* Makes virtual point lights by transform feedback [Dong 2009 §4, §6].
 *
 * Each VPL reads the RSM at a Halton point in its light's domain: a spot's cone, a point light's
 * sphere or a directional light's rectangle. Points of cone and sphere are uniform in solid angle.
 * The papers map a square over the cone and waste 21 %. Reflected flux: Phi_i = albedo_i I(w_i)
 * Omega / n, W. A sample without a hit has flux 0.
 *
 * Each light has n of the N VPLs in proportion to its flux, at least one, and its own points. The
 * 16 VPLs of an interleave slot are contiguous and hold all lights in proportion, because aligned
 * runs of the sequences are stratified. Each pass continues the sequences of the previous one. */
#ifndef PASSES_VPL_H
#define PASSES_VPL_H

#include "passes/targets.h"

struct frame;
struct vpl_buffer;
struct importance_map;
struct light_rays;

/* Most VPLs from which spacings are estimated: a sample that represents all. */
enum { VPL_PARTNERS_MAX = 256 };

struct vpl_desc {
    int count;   /* N */
    int seed;    /* 0: Halton points; else points shifted on the torus */
    float reach; /* requested near-field reach, in spacings of VPLs */
    bool by_importance;
    bool sky_rays; /* traces rays from the environment for its VPLs; needs by_importance */
    bool sampled;  /* some lights are sampled; needs light rays */
    bool of_paths; /* makes path starts; needs by_importance, with a map of later bounces */
    bool lobes;    /* RSMs have specular reflectance */
    bool medium;   /* frames have a medium */
    bool slides;   /* lights may have slides */
};

struct vpl_pass {
    struct vpl_desc desc;
    GLuint program, sums_program, vertices;
    struct vpl_point *points;      /* contents of `samples` */
    int light_count;               /* lights of the last allocation; 0: none yet */
    int dealt_pass;                /* frame->pass of the last allocation */
    double fluxes[LIGHTS_MAX];     /* flux of each light at the last allocation, W */
    int counts[LIGHTS_MAX];        /* n of each */
    struct buffer samples, shares; /* the points; struct vpl_share_block, for BLOCK_VPL_SHARES */
};

bool vpl_pass_init(struct vpl_pass *pass, const struct vpl_desc *desc);
void vpl_pass_free(struct vpl_pass *pass);

/* Allocates the VPLs to the lights and fills pass->shares. */
void vpl_pass_share_out(struct vpl_pass *pass, const struct frame *frame);

/* Fills `vpls` with C(i) = 0 and their sums. Call it after vpl_pass_share_out. `importance` and
 * `rays` are read with desc.by_importance. Timer "vpls". */
void vpl_pass_render(const struct vpl_pass *pass, const struct frame *frame,
                     const struct gbuffer rsm[LIGHT_MAP_KINDS],
                     const struct importance_map *importance, const struct light_rays *rays,
                     const struct vpl_buffer *vpls);

/* Computes the sums of other VPLs, at least min(desc.count, VPL_PARTNERS_MAX) of them. */
void vpl_pass_sum_up(const struct vpl_pass *pass, const struct vpl_buffer *vpls);

#endif
