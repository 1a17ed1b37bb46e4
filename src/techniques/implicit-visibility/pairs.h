/* Links as published, by pairs of nodes [Dong 2011 §4.3.2]. A pair is linked both ways at the
 * coarsest level where neither node is wider than a bin of the other. Then links are pushed from
 * the root to the leaves, bin by bin, and the shorter link of a node and its child is kept. This
 * refines and pushes in one step, on one thread. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_PAIRS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_PAIRS_H

#include "techniques/implicit-visibility/partner.h"

struct pairs {
    int bin_count;
    float *distances;   /* for each bin of each node, leaves first */
    uint32_t *partners; /* in the encoding of partner.h */
    long linked;        /* ends of links between nodes, before refinement */
};

/* Returns the size for `nodes` nodes, bytes. */
size_t pairs_bytes(size_t nodes, int bin_count);

/* Finds partners of all leaves, in the first rows. The caller calls pairs_free. */
void pairs_make(struct pairs *pairs, const struct tree *tree, const struct bins *bins);
void pairs_free(struct pairs *pairs);

#endif
