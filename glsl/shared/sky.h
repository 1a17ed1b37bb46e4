/* A sky as area lights, infinitely far away, and the orthographic view from each. */
#ifndef SHARED_SKY_H
#define SHARED_SKY_H

#include "shared/types.h"

#define ENVIRONMENT_LIGHTS_MAX 256

#define SKY_ROWS 13

struct sky_source {
    vec4 corners[4]; /* unit directions; their last number is 0 */
    vec3 radiance;   /* W/(sr m2) */
    float luminance; /* of it */
    vec3 vector;     /* irradiance over radiance, as a vector: where all of the light is above the horizon */
    float far;       /* where map depth is 1, metres */
    /* The view along the light's middle. Its frame: */
    vec3 right; /* unit */
    float half_width; /* of the map, metres */
    vec3 up;
    float half_height;
    vec3 forward; /* unit: away from the light */
    float unused0;
    vec3 origin;
    float unused1;
    /* Two half sides of the parallelogram that the light is on a plane at distance 1, in that frame. */
    vec4 sides;
    vec4 beyond; /* the number of the next light beyond each quarter: -x -y, +x -y, -x +y, +x +y; its own: none */
    vec4 further; /* likewise beyond those, in the same direction */
};
STD140_SIZE(sky_source, 16 * SKY_ROWS)

/* lib/sky.glsl reads it. */
struct sky_block {
    STRUCT(sky_source) sources[ENVIRONMENT_LIGHTS_MAX];
};
STD140_SIZE(sky_block, 16 * SKY_ROWS * ENVIRONMENT_LIGHTS_MAX)

#endif
