/* passes/visibility/paraboloid.h to its shaders. */
#ifndef SHARED_PARABOLOID_H
#define SHARED_PARABOLOID_H

#include "shared/types.h"

struct paraboloid_params {
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    float map_size;  /* texels */
    float pieces;    /* of a long edge, per radian that it spans at the rim of the map */
    float long_edge; /* shorter ones stay whole, metres */
    float set_back;  /* of casters, metres: simplified ones may have come forward */
    float unused;
};
PASS_BLOCK(paraboloid_params, 48)

/* An edge falls into no more pieces. */
#define PARABOLOID_PIECES_MAX 64.0

#endif
