/* Parameters of passes/volume/. */
#ifndef SHARED_VOLUME_H
#define SHARED_VOLUME_H

#include "shared/types.h"

/* Textures of struct volume. Up to VOLUME_COEFFICIENTS_MAX coefficients come last. */
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
/* Depth maps of lights, LIGHT_MAP_KINDS of them. */
#define UNIT_VOLUME_SHADOWS (UNIT_OWN + 12)

/* Optional targets follow: back, albedo, and two of turned points. */
#define TARGET_VOLUME_SURFACES 0
#define TARGET_VOLUME_RADIOSITY 1
#define TARGET_VOLUME_BACK 2

/* Attributes of points. */
#define ATTRIBUTE_POINT_POSITION 0
#define ATTRIBUTE_POINT_NORMAL 1
#define ATTRIBUTE_POINT_ALBEDO 2

/* Pixels along each side of the reprojected picture. */
#define VOLUME_PIXELS 512

/* Channels that a voxel's rays gather. */
#define VOLUME_VISIBILITY 1 /* channels */
#define VOLUME_RADIANCE 3

/* Greatest known distance to an occupied voxel, in voxels along the axis of the greatest
 * difference. */
#define VOLUME_DISTANCE_MAX 8
/* Greatest distance of empty voxels with coefficients; no surface reads others. */
#define VOLUME_SHELL 2
/* Offset of the distance of voxels within it that no surface reads. */
#define VOLUME_IDLE 16

struct volume_params {
    vec3 corner;      /* of the first voxel, metres */
    float voxel;      /* side of a voxel, metres */
    vec3 cells;       /* voxels along each axis */
    int columns_log2; /* slices in a row of the atlas */
    int rays;         /* rays of a voxel */
    float distance;   /* greatest length of a ray, voxels */
    float irradiance_scale;
    float unused;
    vec2 atlas; /* size, texels */
    vec2 turn;  /* rotation of rays in the pass, from 0 to 1 */
};
PASS_BLOCK(volume_params, 64)

#endif
