/* passes/caustics/caustics.h to its shaders. */
#ifndef SHARED_CAUSTICS_H
#define SHARED_CAUSTICS_H

#include "shared/types.h"

#define UNIT_TRIANGLE_ROWS (UNIT_OWN + 0)   /* of each triangle: its row of smooth materials, 0: none */
#define UNIT_SMOOTH_MATERIALS (UNIT_OWN + 1) /* SMOOTH_TEXELS a row, row 0 left out */
#define UNIT_CORNERS (UNIT_OWN + 2)
#define UNIT_CORNER_POSITIONS (UNIT_OWN + 3)
#define UNIT_CORNER_NORMALS (UNIT_OWN + 4) /* 16-bit signed fractions */
#define UNIT_RAY_LEAVES (UNIT_OWN + 5)
#define UNIT_RAY_ENDS (UNIT_OWN + 6)
#define UNIT_RAY_FLUXES (UNIT_OWN + 7)
#define UNIT_PATCHES (UNIT_OWN + 8) /* two: flux of each triangle of a cell */
#define UNIT_SPLATS (UNIT_OWN + 10)

#define TARGET_RAY_LEAVE 0 /* where a ray leaves the last smooth surface; w: the normal at its end, packed */
#define TARGET_RAY_END 1   /* where it ends; w: RAY_... */
#define TARGET_RAY_FLUX 2  /* W that leave; w: length of the way before, metres */

#define RAY_NONE 0.0
#define RAY_ESCAPES 1.0 /* meets nothing: the end is the medium's */
#define RAY_LANDS 2.0   /* on a surface that scatters */

#define SMOOTH_TEXELS 3    /* base colour and kind; absorption and index of refraction; share let through, thin, two sides */
#define SMOOTH_IS_GLASS 1  /* enum smooth_kind, scene/material.h */
#define SMOOTH_IS_MIRROR 2

#define CHAIN_EVENTS 32 /* smooth surfaces that a ray meets at most */

/* A light's view is a cap of directions, or a disk across a sun's rays. Texels have equal solid angles, or areas. */
struct caustics_params {
    vec3 axis;
    float spread; /* of a cap: 1 - cosine of its edge; of a disk: radius, metres */
    vec3 right;
    float measure; /* of a texel: sr or m2 */
    vec3 up;
    int side; /* texels */
    vec3 start; /* of a sun: the middle of the disk */
    BOOL is_disk;
    vec2 shift; /* of the rays within their texels */
    float reach; /* surfaces are one so near, metres */
    float far;   /* where rays end without a medium, metres */
    vec2 size;   /* of the picture, pixels */
    int chains;  /* of each texel, one above another */
    BOOL points_only;
};
PASS_BLOCK(caustics_params, 96)

#endif
