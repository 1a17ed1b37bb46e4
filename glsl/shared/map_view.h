/* The paraboloid view from a VAL (or a VPL): what its shadow map sees [Dong 2009 §4.2]. */
#ifndef SHARED_MAP_VIEW_H
#define SHARED_MAP_VIEW_H

#include "shared/types.h"

struct map_view {
    vec4 center;  /* metres; w: z_far, the distance at which map depth is 1 */
    vec4 axis;    /* unit; w: extent of the light, metres; 0 for a point */
    vec4 tangent; /* unit, perpendicular to the axis; w: near, metres */
};

/* Views per uniform block: 48 KiB. */
#define MAP_VIEWS_MAX 1024

#endif
