/* passes/direct.h to its shader. */
#ifndef SHARED_DIRECT_H
#define SHARED_DIRECT_H

#include "shared/types.h"

struct direct_params {
    float bias;        /* metres along the normal per metre of a shadow texel */
    float shadow_size; /* texels */
    float unused0, unused1;
};
PASS_BLOCK(direct_params, 16)

#endif
