/* passes/visibility/environment_lighting.h to its shaders. */
#ifndef SHARED_ENVIRONMENT_LIGHTING_H
#define SHARED_ENVIRONMENT_LIGHTING_H

#include "shared/types.h"

#define UNIT_SKY_MAPS (UNIT_OWN + 0)
#define UNIT_SKY_SHARES (UNIT_OWN + 1)

/* Of the table of what lights give by a surface's normal, texels a side. */
#define SKY_SHARES_SIZE 65

struct environment_lighting_params {
    int count;         /* of lights */
    int block;         /* pixels a side of a block that shares its visibility; 0: each pixel looks itself up */
    float bias;        /* texels: what is no higher above a receiver's plane hides nothing */
    float disagree;    /* of all light: where blocks do by more, a pixel looks itself up */
    int unused0, unused1, unused2, unused3;
};
PASS_BLOCK(environment_lighting_params, 32)

#endif
