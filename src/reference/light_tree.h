/* A binary tree over virtual point lights, whose nodes stand for all lights below them [Walter et
 * al. 2005, Lightcuts].
 *
 * A node lights with the sum of their fluxes from the place of one of them, its representative. How
 * much it can give at most follows from the box of their places and the cone of their normals: so
 * much a picture can be off that takes the node for the lights.
 */
#ifndef REFERENCE_LIGHT_TREE_H
#define REFERENCE_LIGHT_TREE_H

#include "reference/geometry_term.h"
#include "shared/vpl.h"

#include <stdint.h>

/* A box of points and a cone of normals there. */
struct light_extent {
    vec3s low, high;
    vec3s axis;         /* unit */
    float cosine, sine; /* of the cone's half angle, up to pi; -1 and 0: all directions */
};

struct light_node {
    struct light_extent extent;
    vec3s flux;         /* of all lights below, W */
    float power;        /* the sum of it, over RGB */
    float area;         /* the least of all lights below, m2 */
    int representative; /* index of the VPL */
    int children[2];    /* indices of nodes; both 0: a leaf, which is its representative */
};

/* The root is node 0, and parents come before children; no nodes where no VPL has flux. */
struct light_tree {
    struct light_node *nodes;
    int count;
};

/* Over those VPLs that met something and have flux. Representatives are picked by flux, at random with the seed. */
void light_tree_init(struct light_tree *tree, const struct vpl *vpls, int count, uint32_t seed);

/* Accepts zeroed trees. */
void light_tree_free(struct light_tree *tree);

static inline bool light_node_is_leaf(const struct light_node *node) {
    return node->children[0] == 0;
}

/* No geometry term between a point of the extent and a light of the node is above this; INFINITY
 * where they may touch and nothing else bounds it. */
float light_node_bound(const struct light_node *node, const struct light_extent *receiver,
                       const struct geometry_term *term);

#endif
