/* A cut through a light tree: nodes that stand for every light exactly once, as few as keep each
 * node's error at a receiver within a share of the sum [Walter et al. 2005, §3]. */
#ifndef REFERENCE_LIGHT_CUT_H
#define REFERENCE_LIGHT_CUT_H

#include "reference/light_tree.h"

struct light_cut_node {
    int node;
    float term; /* the geometry term of its representative, 0 where that is hidden */
    float
        bound; /* power times geometry term: neither its light nor what it stands for is above it, so
                    that it is off by no more; 0: it is off by nothing */
};

/* Zeroed: empty. Keeps its memory for the next receiver. */
struct light_cut {
    struct light_cut_node *nodes; /* by their representatives' numbers */
    int count, room;
};

struct light_cut_desc {
    const struct light_tree *tree;
    struct light_extent receiver;
    struct geometry_term term;
    float tolerance; /* of a node's error, over the sum; 0: no error at all */
    /* The geometry term of a VPL, 0 where it is hidden; at most what bounds its node. */
    float (*evaluate)(const void *context, int vpl);
    const void *context;
};

void light_cut_find(struct light_cut *cut, const struct light_cut_desc *desc);

/* Accepts zeroed cuts. */
void light_cut_free(struct light_cut *cut);

#endif
