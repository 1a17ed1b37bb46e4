/* k-means of VPLs into virtual area lights on the GPU [Dong 2009 §5, §6; Prutkin 2012 §4].
 *
 * One workgroup runs all iterations: it finds the nearest of M centres for each of N VPLs, adds up the VPLs of each
 * VAL and divides by their count. The paper draws points in place of that, an iteration after another.
 * The start is VPL k N / M, of squares VPL k, or what seeds tell; the same each frame, so that VALs move smoothly when the light does
 * (§5.2). A last pass writes C(i); for views MAX blending finds the bounding rectangles. The papers leave the
 * scale of the criterion open: distances are taken over the spread of the VPLs and angles over pi. VPLs
 * without flux take no part.
 */
#ifndef PASSES_CLUSTER_H
#define PASSES_CLUSTER_H

#include "passes/maps.h"
#include "passes/vpls.h"

struct frame;

enum cluster_start {
    CLUSTER_START_SEEDS,  /* from the same VPLs every frame */
    CLUSTER_START_WARM,   /* from the last frame's centres; clusters get lost (§5.2, Fig. 8) */
    CLUSTER_START_RESEED, /* likewise, but empty clusters begin again [Prutkin 2012 §4] */
};

struct cluster_desc {
    int vpl_count, val_count;
    enum cluster_start start;
    const struct texture
        *seeds; /* val_count x 1, R32F: numbers of VPLs, -1 for the usual one's; NULL */
    const struct vpl_weights *weights; /* of VPLs in the means of lengths; NULL: all count alike */
    int iterations;
    int metric;                           /* CLUSTER_METRIC_... (shared/cluster.h) */
    float weight_position, weight_normal; /* w_x, w_alpha; or w_d, w_n */
    float weight_flux;                    /* w_Phi */
    bool means_of_map; /* the last means are those of C(i); else C(i) is what they are nearest to */
    bool has_views;    /* the clusters are VALs, which see: */
    float near_clip;   /* of their maps, over the spread of VPLs */
};

struct cluster_pass {
    struct cluster_desc desc;
    GLuint means_program, map_program;
    GLuint extent_program, views_program;
    struct val_targets vals;
    struct texture sums; /* of VPLs by VAL: passes/lights/cluster_means.comp */
    bool started;        /* the VALs are there */
    struct texture extremes;
    GLuint extremes_framebuffer;
    GLuint vpl_texels;      /* of the VPLs that are read: those that come in, then its own */
    GLuint vpl_sums;        /* theirs */
    struct vpl_buffer vpls; /* the VPLs with C(i) */
    struct map_views views; /* one a VAL, where they have any */
    struct buffer params;
};

bool cluster_pass_init(struct cluster_pass *pass, const struct cluster_desc *desc);
void cluster_pass_free(struct cluster_pass *pass);

/* From VPLs to pass->vpls, the VALs' targets and pass->views. Timer "clustering". */
void cluster_pass_render(struct cluster_pass *pass, const struct frame *frame,
                         const struct vpl_buffer *vpls);

/* C(i) of other lights among the same surfaces; pass->vpls may be the target. */
void cluster_pass_map(const struct cluster_pass *pass, const struct vpl_buffer *vpls,
                      const struct vpl_buffer *to);

/* The targets that hold the last means. */
const struct val_targets *cluster_pass_centers(const struct cluster_pass *pass);

#endif
