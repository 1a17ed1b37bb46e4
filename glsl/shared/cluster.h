/* passes/lights/cluster.h to its shaders. */
#ifndef SHARED_CLUSTER_H
#define SHARED_CLUSTER_H

#include "shared/types.h"

struct cluster_params {
    float weight_position; /* w_x */
    float weight_normal;   /* w_alpha over pi, 1/rad */
    int val_count, vpl_count;
    vec3 bounds_min; /* metres */
    float depth_range; /* map depth of the farthest point of the scene */
    vec3 bounds_max;
    float near_clip; /* over the spread of VPLs */
    BOOL reseed; /* empty clusters begin again */
    int unused0, unused1, unused2;
};
PASS_BLOCK(cluster_params, 64)

#endif
