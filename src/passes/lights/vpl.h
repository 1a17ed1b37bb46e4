/* Virtual point lights by transform feedback [Dong 2009 §4, §6].
 *
 * Each reads the reflective shadow map at a Halton point, mapped to its light's own domain: the cone
 * of a spot, the sphere of a point light (uniform in solid angle, each sample stands for Omega / n),
 * the rectangle of a directional light. The papers map a square over the cone and waste 21 %.
 * Reflected flux Phi_i = albedo_i I(w_i) Omega / n, W. A sample that meets nothing has flux 0.
 *
 * Of several lights each has n of the N by its share of the flux, at least one, and points of its
 * own. The 16 VPLs of an interleave slot are contiguous, and hold all lights by their shares:
 * aligned runs of the sequences are stratified. Each pass goes on in the sequences where the one before
 * ended.
 */
#ifndef PASSES_VPL_H
#define PASSES_VPL_H

#include "passes/targets.h"

struct frame;
struct vpl_buffer;
struct importance_map;
struct light_rays;

/* How many VPLs all others are measured from: as many as say what all would. */
enum { VPL_PARTNERS_MAX = 256 };

struct vpl_desc {
    int count;   /* N */
    int seed;    /* 0 = Halton's points as they are; else shifted on the torus */
    float reach; /* of the near field that is asked for, in spacings of VPLs */
    bool by_importance;
    bool sky_rays; /* by rays from the sky, where light is its; by importance */
    bool of_paths; /* places where paths of light start; by importance of later bounces */
    bool lobes;    /* reflective shadow maps tell how surfaces mirror light */
    bool medium;   /* frames have one */
    bool slides;   /* lights may have some */
};

struct vpl_pass {
    struct vpl_desc desc;
    GLuint program, sums_program, vertices;
    struct vpl_point *points;      /* as the buffer has them */
    int light_count;               /* of the lights that they were dealt to; 0 = none yet */
    int dealt_pass;                /* which they were dealt for */
    double fluxes[LIGHTS_MAX];     /* of them */
    int counts[LIGHTS_MAX];        /* n of each */
    struct buffer samples, shares; /* the points; struct vpl_share_block, for BLOCK_VPL_SHARES */
    struct texture no_maps;        /* a frame without light has no reflective shadow maps */
};

bool vpl_pass_init(struct vpl_pass *pass, const struct vpl_desc *desc);
void vpl_pass_free(struct vpl_pass *pass);

/* Fills pass->shares. */
void vpl_pass_share_out(struct vpl_pass *pass, const struct frame *frame);

/* Fills vpls (C(i) = 0), with their sums; after vpl_pass_share_out. `importance` and `rays` are read where
 * desc.by_importance. Timer "vpls". */
void vpl_pass_render(const struct vpl_pass *pass, const struct frame *frame,
                     const struct gbuffer rsm[LIGHT_MAP_KINDS],
                     const struct importance_map *importance, const struct light_rays *rays,
                     const struct vpl_buffer *vpls);

/* Sets the sums of other VPLs: as many as the pass makes, or VPL_PARTNERS_MAX at least. */
void vpl_pass_sum_up(const struct vpl_pass *pass, const struct vpl_buffer *vpls);

#endif
