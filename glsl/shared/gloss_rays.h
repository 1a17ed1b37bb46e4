/* passes/gather/gloss_rays.h to its shader. */
#ifndef SHARED_GLOSS_RAYS_H
#define SHARED_GLOSS_RAYS_H

#include "shared/interleaving.h"

struct gloss_rays_params {
    STRUCT(interleaving) pattern;
    vec3 bounds_min; /* of the scene, metres */
    float scale;     /* of the stored radiance */
    vec3 bounds_max;
    int rays;         /* of a pixel */
    int first;        /* number of the first one: others in each pass of many */
    float vpl_weight; /* of the VPLs that share a receiver with the rays: one stands for so many */
    float unused0, unused1;
};
PASS_BLOCK(gloss_rays_params, 64)

#endif
