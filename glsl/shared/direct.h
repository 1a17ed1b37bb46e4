/* direct/hard/hard.c to its shader. */
#ifndef SHARED_DIRECT_H
#define SHARED_DIRECT_H

#include "shared/types.h"

struct direct_params {
    float bias;        /* metres along the normal per metre of a shadow texel */
    float shadow_size; /* texels */
    float unused0, unused1;
    vec3 light; /* radiance of a white surface per received light times direct_scale */
    float unused2;
};
PASS_BLOCK(direct_params, 32)

#endif
