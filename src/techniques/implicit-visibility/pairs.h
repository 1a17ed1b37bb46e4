/* Links as the thesis makes them [Dong 2011 §4.3.2]: from pairs of nodes. A pair links both ways at the coarsest level at
 * which neither node is wider than a bin of the other. Then a node and its children compare their links, bin by bin from
 * the root down, and the shorter one is pushed to the leaves: refinement and push in one step. One thread makes them. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_PAIRS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_PAIRS_H

#include "techniques/implicit-visibility/partner.h"

struct pairs {
    int bin_count;
    float *distances;   /* of each bin of each node, leaves first */
    uint32_t *partners; /* as partner.h has them */
    long linked;        /* ends of links between nodes, before refinement */
};

/* Bytes for so many nodes. */
size_t pairs_bytes(size_t nodes, int bin_count);

/* The partners of all leaves end in the first rows. pairs_free it. */
void pairs_make(struct pairs *pairs, const struct tree *tree, const struct bins *bins);
void pairs_free(struct pairs *pairs);

#endif
