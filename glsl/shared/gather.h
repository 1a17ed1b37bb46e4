/* passes/gather/gather.h to its shader. */
#ifndef SHARED_GATHER_H
#define SHARED_GATHER_H

#include "shared/interleaving.h"

#define UNIT_PATHS_KEPT (UNIT_OWN + 0)
#define UNIT_CUTS (UNIT_OWN + 1)

/* How cos cos / d^2 is bounded near a VPL, CLAMP. The disk form factor is that of a disk of the VPL's area. The near
 * field leaves what is near to passes/gather/near_field.h. Spheres spread the VPL's light over a ball [Hašan et al.
 * 2009]. No choices of a user: patches are of later bounces (gather/patch.glsl); rectangles need no bound, and
 * those from RECTANGLE on are rectangles. */
#define GATHER_CLAMP_NONE 0
#define GATHER_CLAMP_VALUE 1
#define GATHER_CLAMP_DISK 2
#define GATHER_CLAMP_NEAR 3
#define GATHER_CLAMP_SPHERE 4
#define GATHER_CLAMP_PATCH 5
#define GATHER_CLAMP_RECTANGLE 6
#define GATHER_CLAMP_RECTANGLE_NEAR 7 /* without their near field */

/* What is gathered: irradiance, or what reflects as by a mirror, of VPLs as points, as balls, or as points as
 * far as rays do not find the same light better. */
#define SPECULAR_NONE 0
#define SPECULAR_POINT 1
#define SPECULAR_SPHERE 2
#define SPECULAR_RAYS 3

struct gather_params {
    STRUCT(interleaving) pattern;
    float scale;    /* of the stored irradiance */
    float clamp_at; /* 1/m2 */
    int block;      /* pixels a side of a block that shares its visibility */
    float turn;     /* of the numbers that say which VPL asks for others, from pass to pass */
    float sphere2;  /* squared radius of a VPL's ball, over the area that it stands for */
    int cut_block;  /* pixels a side of a block that shares a cut */
    int cut_layer;  /* the first of the cuts that are read */
    int specular_rays; /* of a pixel */
    int together;   /* VPLs side by side, of which two test the visibility of all */
    float unseen_rays; /* specular rays for each light, where the camera does not see what they meet */
    int unused0, unused1;
};
STD140_SIZE(gather_params, 64)

#endif
