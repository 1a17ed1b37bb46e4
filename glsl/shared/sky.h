/* A sky as area lights, infinitely far away. */
#ifndef SHARED_SKY_H
#define SHARED_SKY_H

#include "shared/types.h"

#define ENVIRONMENT_LIGHTS_MAX 256

#define SKY_ROWS 9

struct sky_source {
    vec4 corners[4]; /* unit directions; their last number is 0 */
    vec3 radiance;   /* W/(sr m2) */
    float luminance; /* of it */
    vec3 vector;     /* irradiance over radiance, as a vector: where all of the light is above the horizon */
    float unused0;
    /* Points of the light are the parallelogram middle + x side_x + y side_y, x and y from -1 to 1. */
    vec3 middle; /* unit: towards the light */
    float unused1;
    vec3 side_x;
    float unused2;
    vec3 side_y;
    float unused3;
};
STD140_SIZE(sky_source, 16 * SKY_ROWS)

/* lib/sky.glsl reads it. */
struct sky_block {
    STRUCT(sky_source) sources[ENVIRONMENT_LIGHTS_MAX];
};
STD140_SIZE(sky_block, 16 * SKY_ROWS * ENVIRONMENT_LIGHTS_MAX)

#endif
