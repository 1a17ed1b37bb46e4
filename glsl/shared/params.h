/* passes/composite.h to its shaders. */
#ifndef SHARED_PARAMS_H
#define SHARED_PARAMS_H

#include "shared/types.h"

struct composite_params {
    float samples;    /* of a pixel */
    float indirect;   /* radiance of a white surface per stored irradiance */
    float exposure;   /* factor */
    float tone_map;   /* 0 clamp, 1 filmic */
    float layer;      /* what to write, LAYER_... */
    float scale;      /* radiance per stored radiance */
    float unused0, unused1;
};
STD140_SIZE(composite_params, 32)

#define LAYER_BEAUTY 0
#define LAYER_DIRECT 1
#define LAYER_INDIRECT 2
#define LAYER_ALBEDO 3
#define LAYER_NORMAL 4
#define LAYER_DEPTH 5

#endif
