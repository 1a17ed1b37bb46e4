/* inspect/probe.h to its shader. */
#ifndef SHARED_PROBE_H
#define SHARED_PROBE_H

#include "shared/types.h"

struct probe_params {
    vec3 position; /* of a surface */
    float unused0;
    vec3 normal;
    float unused1;
};
PASS_BLOCK(probe_params, 32)

#endif
