/* passes/gather/blur.h to its shaders. */
#ifndef SHARED_BLUR_H
#define SHARED_BLUR_H

#include "shared/interleaving.h"

struct blur_params {
    STRUCT(interleaving) pattern; /* of the picture that is read */
    ivec2 along;                  /* one pixel */
    int radius;                   /* taps to each side along */
    int rows;                     /* of such taps to each side across */
    float distance;               /* alpha, over the picture's height at the pixel's depth */
    float cosine;                 /* beta */
    int unused0, unused1;
    vec3 radii;                   /* of windows: of pixels that no list has, and of each grade */
    float unused2;
    vec3 taken_radii;             /* likewise, but of what a pixel that no list has takes of them */
    float unused3;
    vec3 weights;                 /* of their estimates: as many more lights have they */
    float unused4;
};
PASS_BLOCK(blur_params, 96)

#endif
