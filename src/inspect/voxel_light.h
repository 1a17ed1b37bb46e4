/* The light that arrives at one voxel of a volume, as spherical harmonics: what shades the surfaces beside it. */
#ifndef INSPECT_VOXEL_LIGHT_H
#define INSPECT_VOXEL_LIGHT_H

#include "renderer/renderer.h"

enum { VOXEL_LIGHT_COEFFICIENTS = 9 };

struct voxel_light {
    int order;       /* 2 or 3; 0: there is no such voxel */
    float middle[3]; /* of the voxel, metres */
    /* RGB of radiance, W/(sr m2), in the order of glsl/lib/sh.glsl: 4 of order 2, 9 of order 3. */
    float coefficients[VOXEL_LIGHT_COEFFICIENTS][3];
};

/* Of the empty voxel nearest to 1.5 voxels above a surface, at most a voxel away, in the last frame of a technique with the
 * output `voxels`. Reads back, and so waits for the GPU. */
void voxel_light_read(struct voxel_light *light, struct renderer *renderer, const float position[3],
                      const float normal[3]);

/* What arrives from a direction, of length 1: the sum of coefficients times harmonics, which may be negative. */
void voxel_light_radiance(const struct voxel_light *light, const float direction[3], float rgb[3]);

#endif
