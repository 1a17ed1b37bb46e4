/* passes/lights/cluster.h to its shaders. */
#ifndef SHARED_CLUSTER_H
#define SHARED_CLUSTER_H

#include "shared/types.h"

struct cluster_params {
    float weight_position; /* w_x */
    float weight_normal;   /* w_alpha over pi, 1/rad */
    int val_count, vpl_count;
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    BOOL reseed; /* empty clusters begin again */
};
PASS_BLOCK(cluster_params, 48)

#endif
