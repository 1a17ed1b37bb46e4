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
    int detail_radius;            /* of pixels with few like neighbours */
    float detail_weight;          /* of their estimates: as many more lights have they */
};
PASS_BLOCK(blur_params, 48)

#endif
