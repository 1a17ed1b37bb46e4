/* passes/lights/bounce.h to its shaders. */
#ifndef SHARED_BOUNCE_H
#define SHARED_BOUNCE_H

#include "shared/types.h"

/* A path's row of numbers: which VPL it begins at and where it leaves one, and then the directions of its rays. */
#define BOUNCE_ROW_CHOICE 0
#define BOUNCE_ROW_RAYS 1

/* How much room a VPL has is told by so many runs of those beside it, of at most so many in all. */
#define BOUNCE_RUNS 8
#define BOUNCE_PARTNERS 2048

struct bounce_params {
    int vpls, paths, bounces;
    float start;  /* above a VPL of the light's own map, metres */
    float radius; /* of the scene */
    float unused0, unused1, unused2;
};
PASS_BLOCK(bounce_params, 32)

#endif
