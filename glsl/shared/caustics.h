/* Parameters of passes/caustics/caustics.h. */
#ifndef SHARED_CAUSTICS_H
#define SHARED_CAUSTICS_H

#include "shared/smooth.h"

#define UNIT_RAY_LEAVES (UNIT_SMOOTH_END + 0)
#define UNIT_RAY_ENDS (UNIT_SMOOTH_END + 1)
#define UNIT_RAY_FLUXES (UNIT_SMOOTH_END + 2)
#define UNIT_PATCHES (UNIT_SMOOTH_END + 3) /* two: flux of each triangle of a cell */
#define UNIT_SPLATS (UNIT_SMOOTH_END + 5)

#define TARGET_RAY_LEAVE 0 /* last point on a smooth surface; w: packed normal at the end */
#define TARGET_RAY_END 1   /* end point; w: RAY_... */
#define TARGET_RAY_FLUX 2  /* W that leave; w: length of the way before, metres */

/* Light between two smooth surfaces: one segment a ray. */
#define TARGET_BETWEEN_LEAVE 3 /* w: W, sum of three channels; 0: none */
#define TARGET_BETWEEN_END 4   /* w: red and green over the sum, BETWEEN_LEVELS steps each */
#define BETWEEN_LEVELS 4095.0  /* two values are exact in a float */

/* Indices of a ray's random numbers: one each smooth surface from 0 on, one for its segment between
 * two, one for its lines. */
#define BETWEEN_NUMBERS (CHAIN_EVENTS + 1)
#define LINE_NUMBERS (CHAIN_EVENTS + 2)

#define RAY_NONE 0.0
#define RAY_ESCAPES 1.0 /* no hit: it ends with the medium */
#define RAY_LANDS 2.0   /* hits a surface that is not smooth */

/* A light's view is a cap of directions, or a disk across a sun's rays. Texels have equal solid
 * angles or areas. */
struct caustics_params {
    vec3 axis;
    float spread; /* cap: 1 - cosine of its edge; disk: radius, metres */
    vec3 right;
    float measure; /* of a texel: sr or m2 */
    vec3 up;
    int side;   /* texels */
    vec3 start; /* sun: centre of the disk */
    BOOL is_disk;
    vec2 shift;  /* offset of the rays in their texels */
    float reach; /* distance within which surfaces count as one, metres */
    float far;   /* end of rays without a medium, metres */
    vec2 size;   /* of the picture, pixels */
    int chains;  /* of each texel, stacked vertically */
    BOOL points_only;
    float line_weight; /* of published lines, 1/m */
    float line_step;   /* step along a pixel's ray, metres */
    float line_reach;  /* reach of the Gaussian around a step, metres */
    int unused;
};
PASS_BLOCK(caustics_params, 112)

#endif
