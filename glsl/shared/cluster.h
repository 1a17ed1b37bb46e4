/* Parameters of passes/lights/cluster.h. */
#ifndef SHARED_CLUSTER_H
#define SHARED_CLUSTER_H

#include "shared/types.h"

#define UNIT_SEEDS (UNIT_OWN + 0)

/* Images of passes/lights/cluster_means.comp; it has no others. */
#define IMAGE_VAL_POSITION 0
#define IMAGE_VAL_NORMAL 1
#define IMAGE_VAL_FLUX 2
#define IMAGE_VAL_SUMS 3

/* Invocations of a workgroup. Their VPLs fit the 32 KiB that OpenGL guarantees for shared
 * memory. */
#define CLUSTER_GROUP 512

/* Most VPL groups of a dispatch: llvmpipe ends all loops of an invocation after 65535 steps in
 * total. Half of the steps remain for the search of seeds. */
#define CLUSTER_STEPS_MAX 32768
#define CLUSTER_STEPS(vals) ((vals) + (3 * (vals) + CLUSTER_GROUP - 1) / CLUSTER_GROUP * CLUSTER_GROUP)
#define CLUSTER_GROUPS_MAX(vals) (CLUSTER_STEPS_MAX / CLUSTER_STEPS(vals))

/* METRIC: lengths and angles [Dong 2009 §5.1]; or their squares and those of hues, with
 * flux-weighted means [Prutkin 2012, eq. 1]. */
#define CLUSTER_METRIC_LENGTHS 0
#define CLUSTER_METRIC_SQUARES 1

/* Seed of a cluster that stays empty. -1 selects the default VPL. */
#define VAL_SEED_NOWHERE (-2.0)

struct cluster_params {
    float weight_position; /* w_x */
    float weight_normal;   /* lengths: w_alpha over pi, 1/rad */
    int val_count, vpl_count;
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    BOOL reseed;       /* empty clusters get new seeds */
    float weight_flux; /* squares: w_Phi */
    BOOL seeds;        /* all VALs start at their seeds */
    int iterations;
    int first_vpl; /* of a part of an iteration; else 0 */
};
PASS_BLOCK(cluster_params, 64)

#endif
