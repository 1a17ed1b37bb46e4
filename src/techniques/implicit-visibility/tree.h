/* Builds a tree of surface elements by position and normal [Dong 2011 §4.3.1]: once, then refits
 * it in each frame. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_TREE_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_TREE_H

#include "techniques/implicit-visibility/elements.h"

enum { TREE_CHILDREN = 4 };

struct tree_node {
    float position[3], area; /* area-weighted mean, metres; sum, m2 */
    /* Area-weighted mean, shorter than 1 if normals differ; radius of all leaves below, metres. */
    float normal[3], radius;
    uint32_t children[TREE_CHILDREN]; /* numbers below the node's own; TREE_NONE: unused */
};

#define TREE_NONE UINT32_MAX

/* Leaves come first, in the order of the elements. Children come before parents; the root is
 * last. */
struct tree {
    struct tree_node *nodes;
    int leaf_count, count;
};

/* Builds the tree and sorts the elements into the order of the leaves. At least one element. size:
 * distance that equals a rotation by one radian, metres. */
void tree_init(struct tree *tree, struct elements *elements, float size);
void tree_free(struct tree *tree);

/* Refits all nodes to the elements' positions and normals. */
void tree_pull_up(struct tree *tree, const struct elements *elements);

/* Computes area-weighted means of all inner nodes from the leaves' values, which come first. The
 * fourth component is unused. */
void tree_pull_up_values(const struct tree *tree, float (*values)[4]);

#endif
