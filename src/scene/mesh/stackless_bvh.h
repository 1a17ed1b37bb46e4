/* A BVH for shaders without a stack: boxes in depth-first order, each with the index to continue at
 * after a miss [Smits 1998, §3]. Box sides are rounded outwards to 16 bits, so a box is one texel.
 *
 * Texels of four numbers (src/passes/visibility/bvh.glsl):
 *     0, 1      header: lower bounds, end of the boxes in texels; box steps a metre, clearance
 *     boxes     low and high sides, two to a number; STACKLESS_LEAF with the first texel and count
 *               of its triangles, or the index after the box's contents
 *     triangles three texels: a corner, two edges, 64 bits of opaque parts (scene/mesh/opacity.h),
 *               the triangle's number in the geometry
 */
#ifndef SCENE_MESH_STACKLESS_BVH_H
#define SCENE_MESH_STACKLESS_BVH_H

#include "scene/mesh/bvh.h"

struct stackless_bvh {
    uint32_t (*texels)[4];
    uint32_t count;
};

struct stackless_bvh_desc {
    float low[3], high[3]; /* bounds of the triangles, metres */
    /* Offset of ray origins above surfaces, and of ray ends, metres. */
    float clearance;
};

void stackless_bvh_init(struct stackless_bvh *stackless, const struct bvh *tree,
                        const struct stackless_bvh_desc *desc);

/* Accepts a zeroed object. */
void stackless_bvh_free(struct stackless_bvh *stackless);

#endif
