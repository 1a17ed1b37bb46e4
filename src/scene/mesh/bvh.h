/* Triangles for rays: a binary tree of boxes, built on all cores. A node is split where the surface area heuristic over
 * bins has its least, and is a leaf where no split saves more than it costs [Wald 2007]. What shaders walk is laid out of it (scene/mesh/stackless_bvh.h); the path tracer has Embree
 * (reference/scene/ray_scene.h).
 */
#ifndef SCENE_MESH_BVH_H
#define SCENE_MESH_BVH_H

#include <stdbool.h>
#include <stdint.h>

#include "base/unit.h"

/* By its corners: the front is where they go counter-clockwise. */
struct bvh_triangle {
    vec3s corner, edges[2]; /* from the corner to the two others, metres */
    uint32_t opaque[2];     /* which of its 64 parts are (scene/mesh/opacity.h) */
    uint32_t number;        /* in the geometry */
};

struct bvh_box {
    float low[3], high[3];
};

struct bvh_node {
    struct bvh_box box;
    uint32_t first; /* triangle of a leaf; else the first of two children, which are contiguous */
    uint32_t count; /* 0: no leaf */
};

struct bvh {
    struct bvh_triangle *triangles; /* leaf by leaf */
    struct bvh_node *nodes;         /* the root first */
    uint32_t count, node_count;
};

float bvh_box_half_surface(const struct bvh_box *box);

/* Takes the triangles, an array of the heap. */
void bvh_init(struct bvh *tree, struct bvh_triangle *triangles, uint32_t count);
void bvh_free(struct bvh *tree);

#endif
