/* A tree of triangles laid out for shaders, which have no stack: boxes in the order in which they are entered, each with
 * the place to go on at where a ray misses it [Smits 1998, §3]. Boxes are rounded outwards to 16 bits a side of the
 * bounds, so that one texel has one.
 *
 * Texels of four numbers (glsl/visibility/triangle_tree.glsl):
 *     0, 1      the header: where the bounds begin, and how many texels the boxes' end is; steps of a box a metre, and
 *               the clearance
 *     boxes     low and high sides, two to a number; THREADED_LEAF with the triangles' first texel and count, or where to
 *               go on past what the box holds
 *     triangles three: a corner and the edges from it, and 64 bits that say which parts are opaque (scene/mesh/opacity.h);
 *               and the triangle's number in the geometry
 */
#ifndef SCENE_MESH_THREADED_TREE_H
#define SCENE_MESH_THREADED_TREE_H

#include "scene/mesh/triangle_tree.h"

struct threaded_tree {
    uint32_t (*texels)[4];
    uint32_t count;
};

struct threaded_tree_desc {
    float low[3], high[3]; /* bounds of the triangles, metres */
    /* Rays begin so far above a surface, and end so far before their end, metres. */
    float clearance;
};

void threaded_tree_init(struct threaded_tree *threaded, const struct triangle_tree *tree,
                        const struct threaded_tree_desc *desc);

/* Accepts zeroed ones. */
void threaded_tree_free(struct threaded_tree *threaded);

#endif
