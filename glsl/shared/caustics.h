/* passes/caustics/caustics.h to its shaders. */
#ifndef SHARED_CAUSTICS_H
#define SHARED_CAUSTICS_H

#include "shared/smooth.h"

#define UNIT_RAY_LEAVES (UNIT_SMOOTH_END + 0)
#define UNIT_RAY_ENDS (UNIT_SMOOTH_END + 1)
#define UNIT_RAY_FLUXES (UNIT_SMOOTH_END + 2)
#define UNIT_PATCHES (UNIT_SMOOTH_END + 3) /* two: flux of each triangle of a cell */
#define UNIT_SPLATS (UNIT_SMOOTH_END + 5)

#define TARGET_RAY_LEAVE                                                                           \
    0 /* where a ray leaves the last smooth surface; w: the normal at its end, packed */
#define TARGET_RAY_END 1  /* where it ends; w: RAY_... */
#define TARGET_RAY_FLUX 2 /* W that leave; w: length of the way before, metres */

/* Light between two smooth surfaces: one segment of each ray. */
#define TARGET_BETWEEN_LEAVE 3 /* w: W, the sum of three channels; 0: none */
#define TARGET_BETWEEN_END 4   /* w: red and green over the sum, BETWEEN_LEVELS steps each */
#define BETWEEN_LEVELS 4095.0  /* two are exact in a float */

/* Numbers of chance of a ray: of each smooth surface from 0 on, of its segment between two, and of its lines by light. */
#define BETWEEN_NUMBERS (CHAIN_EVENTS + 1)
#define LINE_NUMBERS (CHAIN_EVENTS + 2)

#define RAY_NONE 0.0
#define RAY_ESCAPES 1.0 /* meets nothing: the end is the medium's */
#define RAY_LANDS 2.0   /* on a surface that scatters */

/* A light's view is a cap of directions, or a disk across a sun's rays. Texels have equal solid angles, or areas. */
struct caustics_params {
    vec3 axis;
    float spread; /* of a cap: 1 - cosine of its edge; of a disk: radius, metres */
    vec3 right;
    float measure; /* of a texel: sr or m2 */
    vec3 up;
    int side;   /* texels */
    vec3 start; /* of a sun: the middle of the disk */
    BOOL is_disk;
    vec2 shift;  /* of the rays within their texels */
    float reach; /* surfaces are one so near, metres */
    float far;   /* where rays end without a medium, metres */
    vec2 size;   /* of the picture, pixels */
    int chains;  /* of each texel, one above another */
    BOOL points_only;
    float line_weight; /* of published lines, 1/m */
    float line_step;   /* of a pixel's ray, metres */
    float line_reach;  /* of the Gaussian around a step, metres */
    int unused;
};
PASS_BLOCK(caustics_params, 112)

#endif
