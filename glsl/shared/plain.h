/* passes/gather/plain.h to its shaders. */
#ifndef SHARED_PLAIN_H
#define SHARED_PLAIN_H

#include "shared/types.h"

/* A pixel this far off another's plane, over the picture's height there, is another surface. */
#define PLANE_APART 0.008f

struct plain_params {
    float distance;   /* alpha of the blur, over the picture's height at the pixel's depth */
    float code_apart; /* the sum of what octahedral codes of a block's normals may differ by */
    int width;        /* of the picture, pixels */
    int reach;        /* around a block, blocks */
    int unused0, unused1, unused2, unused3;
};
PASS_BLOCK(plain_params, 32)

#endif
