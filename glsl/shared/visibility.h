/* passes/visibility/visibility.h to visibility/visibility.glsl: how a point looks itself up in the maps. */
#ifndef SHARED_VISIBILITY_H
#define SHARED_VISIBILITY_H

#include "shared/types.h"

struct visibility_params {
    float bias;     /* of the point along its normal, texels of the map */
    float map_size; /* texels */
    float map_bias; /* of a hard lookup, of the distance */
    float shift;    /* of the receiver depth, map depth */
    float gain;     /* of the blocked fraction about one half */
    float sharpen_a, sharpen_b;
    float unused;
};
STD140_SIZE(visibility_params, 32)

#endif
