/* passes/gather/blur.h to its shaders. */
#ifndef SHARED_BLUR_H
#define SHARED_BLUR_H

#include "shared/interleaving.h"

#define UNIT_BLUR_TAPS (UNIT_OWN + 0)
#define UNIT_ADAPTIVE_IRRADIANCE (UNIT_OWN + 1)

/* Levels of taps: pixels that no list has; those of lists' levels; and edges where light is steep. */
#define BLUR_LEVEL_NONE 0
#define BLUR_LEVEL_OF_LIST(level) (1 + (level))
#define BLUR_LEVEL_STEEP (1 + PIXEL_LEVELS)

struct blur_params {
    STRUCT(interleaving) pattern; /* of the picture that is read */
    ivec2 along;                  /* one pixel */
    int radius;                   /* taps to each side along */
    int rows;                     /* of such taps to each side across */
    float distance;               /* alpha, over the picture's height at the pixel's depth */
    float cosine;                 /* beta */
    float inverse_power; /* of all lights; times area and irradiance as it is stored: a share */
    float detail_cosine; /* beta of BLUR_LEVEL_OF_LIST(PIXEL_LEVEL_DETAIL) */
    vec4 radii;       /* of windows: of taps of each level */
    vec4 taken_radii; /* likewise, but of what a pixel that no list has takes of them */
    vec4 weights;     /* of their estimates: as many more lights have they */
};
PASS_BLOCK(blur_params, 96)

#endif
