/* A tree of surface elements, by position and normal [Dong 2011 §4.3.1]: built once, and pulled up in each frame. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_TREE_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_TREE_H

#include "techniques/implicit-visibility/elements.h"

enum { TREE_CHILDREN = 4 };

struct tree_node {
    float position[3], area; /* mean by area; sum, m2 */
    float normal[3],
        radius; /* mean by area, shorter than 1 where normals differ; of all below, m */
    uint32_t children[TREE_CHILDREN]; /* numbers below the node's own; TREE_NONE: no more */
};

#define TREE_NONE UINT32_MAX

/* Leaves come first, in the order of the elements; children before their parents; the root is last. */
struct tree {
    struct tree_node *nodes;
    int leaf_count, count;
};

/* Sorts the elements into the order of the leaves. There is one at least. size: metres that a turn by one radian counts for. */
void tree_init(struct tree *tree, struct elements *elements, float size);
void tree_free(struct tree *tree);

/* Takes the elements' positions and normals, and those of all nodes above. */
void tree_pull_up(struct tree *tree, const struct elements *elements);

/* The leaves' values stand first: means by area of all other nodes. The fourth component is unused. */
void tree_pull_up_values(const struct tree *tree, float (*values)[4]);

#endif
