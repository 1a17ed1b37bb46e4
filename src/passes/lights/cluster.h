/* Clusters VPLs into virtual area lights by k-means on the GPU [Dong 2009 §5, §6; Prutkin 2012
 * §4].
 *
 * One workgroup runs all iterations. It assigns each of N VPLs to the nearest of M centres, then
 * divides the sums of each VAL by its count. The paper draws points instead, one iteration after
 * another. Initial centre k is VPL k N / M; with the squared metric VPL k; with `seeds` the given
 * VPL. The seeds are the same in each frame, so VALs move smoothly with the light (§5.2). A last
 * pass writes C(i). For views, MAX blending finds the bounding rectangles. The papers leave the
 * metric's scale open: distances are over the spread of the VPLs, angles over pi. VPLs without flux
 * are ignored. */
#ifndef PASSES_CLUSTER_H
#define PASSES_CLUSTER_H

#include "passes/maps.h"
#include "passes/vpls.h"

struct frame;

enum cluster_start {
    CLUSTER_START_SEEDS,  /* from the same VPLs in every frame */
    CLUSTER_START_WARM,   /* from the last frame's centres; clusters get lost (§5.2, Fig. 8) */
    CLUSTER_START_RESEED, /* as WARM, but reseeds empty clusters [Prutkin 2012 §4] */
};

struct cluster_desc {
    int vpl_count, val_count;
    enum cluster_start start;
    const struct texture
        *seeds; /* val_count x 1, R32F: VPL numbers, -1: the default VPL; or NULL */
    /* Weights of VPLs in the means of the length metric; NULL: equal. */
    const struct vpl_weights *weights;
    int iterations;
    int metric;                           /* CLUSTER_METRIC_... (shared/cluster.h) */
    float weight_position, weight_normal; /* w_x, w_alpha; or w_d, w_n */
    float weight_flux;                    /* w_Phi */
    /* Updates the means after the last assignment; else C(i) is the VPL's nearest mean. */
    bool means_of_map;
    bool has_views;  /* clusters are VALs with depth maps */
    float near_clip; /* near plane of the maps, over the spread of VPLs */
};

struct cluster_pass {
    struct cluster_desc desc;
    GLuint means_program, map_program;
    GLuint extent_program, views_program;
    struct val_targets vals;
    struct texture sums; /* sums of VPLs by VAL (passes/lights/cluster_means.comp) */
    bool started;        /* VALs of an earlier frame exist */
    struct texture extremes;
    GLuint extremes_framebuffer;
    GLuint vpl_texels;      /* VPL texels that the pass reads: the input, then pass->vpls */
    GLuint vpl_sums;        /* sums of the input VPLs */
    struct vpl_buffer vpls; /* the VPLs with C(i) */
    struct map_views views; /* one a VAL, with desc.has_views */
    struct buffer params;
};

bool cluster_pass_init(struct cluster_pass *pass, const struct cluster_desc *desc);
void cluster_pass_free(struct cluster_pass *pass);

/* Clusters `vpls` into pass->vpls, pass->vals and pass->views. Timer "clustering". */
void cluster_pass_render(struct cluster_pass *pass, const struct frame *frame,
                         const struct vpl_buffer *vpls);

/* Writes C(i) of other lights among the same surfaces into `to`, which may be pass->vpls. */
void cluster_pass_map(const struct cluster_pass *pass, const struct vpl_buffer *vpls,
                      const struct vpl_buffer *to);

/* Returns the VALs of the last iteration. */
const struct val_targets *cluster_pass_centers(const struct cluster_pass *pass);

#endif
