/* A bounding volume hierarchy of triangles, built on all cores by binned surface area heuristic
 * [Wald 2007]. Shaders use its layout in scene/mesh/stackless_bvh.h; the path tracer uses Embree
 * (reference/scene/ray_scene.h). */
#ifndef SCENE_MESH_BVH_H
#define SCENE_MESH_BVH_H

#include <stdbool.h>
#include <stdint.h>

#include "base/unit.h"

/* A triangle; its front is counter-clockwise. */
struct bvh_triangle {
    vec3s corner, edges[2]; /* corner; edges to the other corners, metres */
    uint32_t opaque[2];     /* bit mask of its 64 opaque parts (scene/mesh/opacity.h) */
    uint32_t number;        /* number in the geometry */
};

struct bvh_box {
    float low[3], high[3];
};

struct bvh_node {
    struct bvh_box box;
    uint32_t first; /* leaf: first triangle; else the first of two adjacent children */
    uint32_t count; /* triangles of a leaf; 0: inner node */
};

struct bvh {
    struct bvh_triangle *triangles; /* in the order of the leaves */
    struct bvh_node *nodes;         /* root first */
    uint32_t count, node_count;
};

float bvh_box_half_surface(const struct bvh_box *box);

/* Builds the tree. It takes ownership of `triangles`, a heap array. */
void bvh_init(struct bvh *tree, struct bvh_triangle *triangles, uint32_t count);
void bvh_free(struct bvh *tree);

#endif
