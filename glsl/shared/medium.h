/* A participating medium, and the light that it sends to the camera. */
#ifndef SHARED_MEDIUM_H
#define SHARED_MEDIUM_H

#include "shared/light.h"

/* A homogeneous participating medium in the scene's bounding sphere (scene/medium.h); lib/medium.glsl reads it. */
struct medium_params {
    vec3 center; /* of the sphere */
    float radius;
    vec3 scattering; /* 1/m */
    float g;         /* mean cosine of the scattering */
    vec3 extinction; /* 1/m */
    float mean_extinction; /* of RGB */
};
STD140_SIZE(medium_params, 48)

/* passes/picture/airlight.h to its shaders. */
#define UNIT_AIRLIGHT (UNIT_OWN + 0) /* what is blurred */

/* How a light is looked up and stepped along: with one view, with six, without a place. */
#define AIRLIGHT_SPOT 0
#define AIRLIGHT_POINT 1
#define AIRLIGHT_DIRECTIONAL 2
#define AIRLIGHT_KINDS 3

/* Pixels of a pattern of so many a side have steps at different places; the blur is as wide. */
#define AIRLIGHT_PATTERN 8

struct airlight_params {
    float scale; /* stored = radiance times this */
    float turn;  /* of the pass, from 0 to 1 */
    ivec2 along; /* of the blur */
    /* Of each light: steps; how wide its share of a lamp is, metres; AIRLIGHT_FLAT_... Of such a lamp its middle and
     * two half sides. */
    vec4 sources[LIGHTS_MAX], middles[LIGHTS_MAX], rights[LIGHTS_MAX], ups[LIGHTS_MAX];
};
STD140_SIZE(airlight_params, 16 + 4 * 16 * LIGHTS_MAX)

/* Flat lamps, over which steps are spread. */
#define AIRLIGHT_FLAT_NONE 0
#define AIRLIGHT_FLAT_RECTANGLE 1
#define AIRLIGHT_FLAT_DISK 2

#endif
