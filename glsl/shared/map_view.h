/* The paraboloid view from a VAL (or a VPL): what its shadow map sees [Dong 2009 §4.2]. Transform
 * feedback writes it (visibility/map_view_output.glsl). */
#ifndef SHARED_MAP_VIEW_H
#define SHARED_MAP_VIEW_H

#include "shared/types.h"

#define MAP_VIEW_ROWS 3

struct map_view {
    vec3 center; /* metres */
    float z_far; /* the distance at which map depth is 1, metres */
    vec3 axis;   /* unit */
    float extent; /* of the light, metres; 0 for a point */
    vec3 tangent; /* unit, perpendicular to the axis */
    float near;   /* metres */
};
STD140_SIZE(map_view, 16 * MAP_VIEW_ROWS)

/* For near: all casters are nearer, and nobody asks. */
#define MAP_VIEW_EMPTY 1e30

/* Views per uniform block: 48 KiB. */
#define MAP_VIEWS_MAX 1024

#endif
