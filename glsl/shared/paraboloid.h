/* passes/visibility/paraboloid.h to its shaders. */
#ifndef SHARED_PARABOLOID_H
#define SHARED_PARABOLOID_H

#include "shared/types.h"

struct paraboloid_params {
    float map_size;  /* texels */
    float pieces;    /* of a long edge, per radian that it spans at the rim of the map */
    float long_edge; /* shorter ones stay whole, metres */
    float set_back;  /* of casters, metres: simplified ones may have come forward */
};
PASS_BLOCK(paraboloid_params, 16)

/* An edge falls into no more pieces. */
#define PARABOLOID_PIECES_MAX 64.0

#endif
