/* A participating medium, and its light towards the camera. */
#ifndef SHARED_MEDIUM_H
#define SHARED_MEDIUM_H

#include "shared/light.h"

/* A homogeneous participating medium in the scene's bounding sphere (scene/medium.h), for
 * lib/medium.glsl. */
struct medium_params {
    vec3 center; /* centre of the sphere */
    float radius;
    vec3 scattering;       /* 1/m */
    float g;               /* mean cosine of the scattering */
    vec3 extinction;       /* 1/m */
    float mean_extinction; /* of RGB */
};
STD140_SIZE(medium_params, 48)

/* Parameters of passes/picture/airlight.h. */
#define UNIT_AIRLIGHT (UNIT_OWN + 0) /* input of the blur */

/* Lookups and steps of a light: with one view, with six, at infinite distance. */
#define AIRLIGHT_SPOT 0
#define AIRLIGHT_POINT 1
#define AIRLIGHT_DIRECTIONAL 2
#define AIRLIGHT_KINDS 3

/* Side of a pattern of pixels with different steps, and width of the blur. */
#define AIRLIGHT_PATTERN 8

struct airlight_params {
    float scale; /* stored = radiance times this */
    float turn;  /* rotation of the pass, from 0 to 1 */
    ivec2 along; /* direction of the blur */
    /* For each light: number of steps; width of its part of a lamp, metres; AIRLIGHT_FLAT_.... For
     * a flat lamp also its centre and two half sides. */
    vec4 sources[LIGHTS_MAX], middles[LIGHTS_MAX], rights[LIGHTS_MAX], ups[LIGHTS_MAX];
};
STD140_SIZE(airlight_params, 16 + 4 * 16 * LIGHTS_MAX)

/* Flat lamps, over which steps are spread. */
#define AIRLIGHT_FLAT_NONE 0
#define AIRLIGHT_FLAT_RECTANGLE 1
#define AIRLIGHT_FLAT_DISK 2

#endif
