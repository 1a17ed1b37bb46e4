/* A homogeneous participating medium in the scene's bounding sphere (scene/medium.h); lib/medium.glsl reads it. */
#ifndef SHARED_MEDIUM_H
#define SHARED_MEDIUM_H

#include "shared/types.h"

struct medium_params {
    vec3 center; /* of the sphere */
    float radius;
    vec3 scattering; /* 1/m */
    float g;         /* mean cosine of the scattering */
    vec3 extinction; /* 1/m */
    float mean_extinction; /* of RGB */
};
STD140_SIZE(medium_params, 48)

#endif
