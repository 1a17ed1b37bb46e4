/* passes/lights/cluster.h to its shaders. */
#ifndef SHARED_CLUSTER_H
#define SHARED_CLUSTER_H

#include "shared/types.h"

#define UNIT_SEEDS (UNIT_OWN + 0)

/* Images of passes/lights/cluster_means.comp, which has no others. */
#define IMAGE_VAL_POSITION 0
#define IMAGE_VAL_NORMAL 1
#define IMAGE_VAL_FLUX 2
#define IMAGE_VAL_SUMS 3

/* Invocations of its workgroup: the VPLs of so many fit the 32 KiB that GL promises for shared memory. */
#define CLUSTER_GROUP 512

/* llvmpipe ends all loops of an invocation after 65535 steps in sum, so a dispatch takes so many groups of VPLs at most.
 * Half of the steps are left for the search of seeds. */
#define CLUSTER_STEPS_MAX 32768
#define CLUSTER_STEPS(vals) ((vals) + (3 * (vals) + CLUSTER_GROUP - 1) / CLUSTER_GROUP * CLUSTER_GROUP)
#define CLUSTER_GROUPS_MAX(vals) (CLUSTER_STEPS_MAX / CLUSTER_STEPS(vals))

/* The criterion, METRIC: lengths and angles [Dong 2009 §5.1], or squares of them and of hues, with means
 * weighted by flux [Prutkin 2012, eq. 1]. */
#define CLUSTER_METRIC_LENGTHS 0
#define CLUSTER_METRIC_SQUARES 1

/* In place of a VPL's number: the cluster stays empty. Below -1, for which the usual VPL stands. */
#define VAL_SEED_NOWHERE (-2.0)

struct cluster_params {
    float weight_position; /* w_x */
    float weight_normal;   /* of lengths: w_alpha over pi, 1/rad */
    int val_count, vpl_count;
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    BOOL reseed;       /* empty clusters begin again */
    float weight_flux; /* of squares: w_Phi */
    BOOL seeds;        /* all VALs begin with their seeds */
    int iterations;
    int first_vpl; /* of a part of an iteration, else 0 */
};
PASS_BLOCK(cluster_params, 64)

#endif
