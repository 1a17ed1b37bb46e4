/* passes/gather/adaptive.h to its shader. */
#ifndef SHARED_ADAPTIVE_H
#define SHARED_ADAPTIVE_H

#include "shared/interleaving.h"

struct adaptive_params {
    STRUCT(interleaving) pattern; /* of the lists */
    float distance; /* alpha of the blur, over the picture's height at the pixel's depth */
    float cosine;   /* beta */
    float apart;    /* likewise: neighbours farther off the pixel's plane are unlike */
    float fewest;   /* like neighbours of a smooth pixel */
    int radius;     /* of the neighbours that are asked, pixels along x and y */
    int block;      /* pixels a side of a block that shares its visibility */
    float sharp_cosine; /* where normals are farther apart, they are so for more than gentle relief */
    int unused;
};
PASS_BLOCK(adaptive_params, 48)

#endif
