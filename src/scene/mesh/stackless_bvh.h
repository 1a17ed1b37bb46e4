/* A tree of triangles laid out for shaders, which have no stack: boxes in the order in which they are entered, each with
 * the place to go on at where a ray misses it [Smits 1998, §3]. Boxes are rounded outwards to 16 bits a side of the
 * bounds, so that one texel has one.
 *
 * Texels of four numbers (src/passes/visibility/bvh.glsl):
 *     0, 1      the header: where the bounds begin, and how many texels the boxes' end is; steps of a box a metre, and
 *               the clearance
 *     boxes     low and high sides, two to a number; STACKLESS_LEAF with the triangles' first texel and count, or where to
 *               go on past what the box holds
 *     triangles three: a corner and the edges from it, and 64 bits that say which parts are opaque (scene/mesh/opacity.h);
 *               and the triangle's number in the geometry
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
    /* Rays begin so far above a surface, and end so far before their end, metres. */
    float clearance;
};

void stackless_bvh_init(struct stackless_bvh *stackless, const struct bvh *tree,
                        const struct stackless_bvh_desc *desc);

/* Accepts zeroed ones. */
void stackless_bvh_free(struct stackless_bvh *stackless);

#endif
