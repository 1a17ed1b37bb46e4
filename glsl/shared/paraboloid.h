/* passes/visibility/paraboloid.h to its shaders. */
#ifndef SHARED_PARABOLOID_H
#define SHARED_PARABOLOID_H

#include "shared/types.h"

struct paraboloid_params {
    vec3 bounds_min;   /* metres */
    float depth_range; /* map depth of the farthest point of the scene */
    vec3 bounds_max;
    float near_clip; /* metres */
    float clip_z;    /* where a map begins, metres above its plane */
    float map_size;  /* texels */
    float unused0, unused1;
};
PASS_BLOCK(paraboloid_params, 48)

#endif
