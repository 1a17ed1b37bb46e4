/* passes/visibility/environment_lighting.h to its shaders. */
#ifndef SHARED_ENVIRONMENT_LIGHTING_H
#define SHARED_ENVIRONMENT_LIGHTING_H

#include "shared/types.h"

#define UNIT_SKY_SHARES (UNIT_OWN + 0)

/* Of the table of what lights give by a surface's normal, texels a side. */
#define SKY_SHARES_SIZE 65

struct environment_lighting_params {
    int count;         /* of lights */
    int block;         /* pixels a side of a block that shares its visibility */
    float disagree;    /* of all light: where blocks do by more, rays start at the pixel */
    int pass;          /* of several: each has other points of the lights */
};
PASS_BLOCK(environment_lighting_params, 16)

/* Lights of one layer of an array, and layers of one draw. */
#define SKY_LAYER_LIGHTS 4
#define SKY_DRAW_LAYERS 8 /* as many lights as a mask has bits */

#endif
