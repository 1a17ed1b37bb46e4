/* The nearest triangle along a ray: a binary tree of boxes, split where the surface area heuristic over bins has its
 * least [Wald 2007]. For the few rays that a frame asks of still surfaces; the path tracer has Embree
 * (reference/scene/ray_scene.h).
 */
#ifndef SCENE_MESH_TRIANGLE_TREE_H
#define SCENE_MESH_TRIANGLE_TREE_H

#include <cglm/struct.h>

#include <stdbool.h>
#include <stdint.h>

/* By its corners: the front is where they go counter-clockwise. */
struct tree_triangle {
    vec3s corner, edges[2]; /* from the corner to the two others, metres */
    /* For those who ask: */
    bool double_sided;  /* of its material */
    uint32_t opaque[2]; /* which of its 64 parts are (scene/mesh/opacity.h) */
};

struct tree_box {
    float low[3], high[3];
};

struct tree_node {
    struct tree_box box;
    uint32_t first; /* triangle of a leaf; else the first of two children, which are contiguous */
    uint32_t count; /* 0: no leaf */
};

struct triangle_tree {
    struct tree_triangle *triangles; /* leaf by leaf */
    struct tree_node *nodes;         /* the root first */
    uint32_t count, node_count;
};

/* Takes the triangles, an array of the heap. */
void triangle_tree_init(struct triangle_tree *tree, struct tree_triangle *triangles,
                        uint32_t count);
void triangle_tree_free(struct triangle_tree *tree);

struct tree_hit {
    float distance; /* in lengths of the direction */
    const struct tree_triangle *triangle;
    bool back;
};

/* False: nothing is met. Thread-safe. */
bool triangle_tree_hit(const struct triangle_tree *tree, vec3s origin, vec3s direction,
                       struct tree_hit *hit);

#endif
