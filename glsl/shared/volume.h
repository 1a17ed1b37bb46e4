/* Passes of volumes (passes/volume/) to their shaders. */
#ifndef SHARED_VOLUME_H
#define SHARED_VOLUME_H

#include "shared/types.h"

/* Textures of struct volume. The coefficients come last: up to VOLUME_COEFFICIENTS_MAX. */
#define UNIT_VOLUME_SURFACES (UNIT_OWN + 0)
#define UNIT_VOLUME_RADIOSITY (UNIT_OWN + 1)
#define UNIT_VOLUME_BACK (UNIT_OWN + 2)
#define UNIT_VOLUME_ALBEDO (UNIT_OWN + 3)
#define UNIT_VOLUME_DISTANCES (UNIT_OWN + 4)
#define UNIT_VOLUME_COEFFICIENTS (UNIT_OWN + 5)
#define VOLUME_COEFFICIENTS_MAX 7
#define UNIT_VOLUME_NEIGHBOURS (UNIT_OWN + 14)
#define UNIT_VOLUME_TURNED_SURFACES (UNIT_OWN + 15)
#define UNIT_VOLUME_TURNED_RADIOSITY (UNIT_OWN + 16)
/* Maps of depth from lights, LIGHT_MAP_KINDS of them. */
#define UNIT_VOLUME_SHADOWS (UNIT_OWN + 12)

/* The others follow, where a volume has them: the back's, the albedo's, and two of turned points. */
#define TARGET_VOLUME_SURFACES 0
#define TARGET_VOLUME_RADIOSITY 1
#define TARGET_VOLUME_BACK 2

/* Attributes of points. */
#define ATTRIBUTE_POINT_POSITION 0
#define ATTRIBUTE_POINT_NORMAL 1
#define ATTRIBUTE_POINT_ALBEDO 2

/* Pixels along each side of the picture that are reprojected. */
#define VOLUME_PIXELS 512

/* What a voxel's rays gather. */
#define VOLUME_VISIBILITY 1 /* channels */
#define VOLUME_RADIANCE 3

/* Distances to the nearest occupied voxel are known up to here, voxels along the axis of the greatest difference. */
#define VOLUME_DISTANCE_MAX 8
/* Empty voxels up to here have coefficients: no surface reads others. */
#define VOLUME_SHELL 2
/* Added to the distance of those that no surface reads all the same. */
#define VOLUME_IDLE 16

struct volume_params {
    vec3 corner;      /* of the first voxel, metres */
    float voxel;      /* side of a voxel, metres */
    vec3 cells;       /* voxels along each axis */
    int columns_log2; /* slices in a row of the atlas */
    int rays;         /* of a voxel */
    float distance;   /* that a ray goes at most, voxels */
    float irradiance_scale;
    float unused;
    vec2 atlas; /* its texels */
    vec2 turn;  /* of rays, another in each pass: from 0 to 1 */
};
PASS_BLOCK(volume_params, 64)

#endif
