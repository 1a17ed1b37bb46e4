/* passes/lights/cluster.h to its shaders. */
#ifndef SHARED_CLUSTER_H
#define SHARED_CLUSTER_H

#include "shared/types.h"

#define UNIT_SUM_POSITION (UNIT_OWN + 0)
#define UNIT_SUM_NORMAL (UNIT_OWN + 1)
#define UNIT_SUM_FLUX (UNIT_OWN + 2)
#define UNIT_SEEDS (UNIT_OWN + 3)

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
    float unused0, unused1, unused2;
};
PASS_BLOCK(cluster_params, 64)

#endif
