/* passes/visibility/paraboloid.h to its shaders. */
#ifndef SHARED_PARABOLOID_H
#define SHARED_PARABOLOID_H

#include "shared/types.h"

struct paraboloid_params {
    float texel;     /* over half of the map */
    float long_edge; /* shorter ones stay straight, metres */
    float set_back;  /* of casters, metres: simplified ones may have come forward */
    float unused;
};
PASS_BLOCK(paraboloid_params, 16)

#endif
