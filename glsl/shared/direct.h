/* direct/hard/hard.c to its shader. */
#ifndef SHARED_DIRECT_H
#define SHARED_DIRECT_H

#include "shared/types.h"

struct direct_params {
    vec3 light; /* radiance of a white surface per received light times direct_scale */
    float unused;
};
PASS_BLOCK(direct_params, 16)

#endif
