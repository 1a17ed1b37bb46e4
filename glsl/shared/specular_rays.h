/* passes/gather/specular_rays.h to its shader. */
#ifndef SHARED_SPECULAR_RAYS_H
#define SHARED_SPECULAR_RAYS_H

#include "shared/interleaving.h"


/* From one ray's place in the lobe's square to the next one's. */
#define SPECULAR_STEP_X 0.7548776662
#define SPECULAR_STEP_Y 0.5698402910

struct specular_rays_params {
    STRUCT(interleaving) pattern;
    vec2 start;       /* of a pass's first ray, in [0, 1): others in each pass of many */
    float scale;      /* of the stored radiance */
    float farthest;   /* beyond all surfaces, metres */
    int rays;         /* of a pixel */
    float vpl_weight; /* of the VPLs that share a receiver with the rays: one stands for so many */
    float unused0, unused1;
};
PASS_BLOCK(specular_rays_params, 48)

#endif
