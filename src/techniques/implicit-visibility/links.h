/* Links of surface elements to their nearest partner in each bin of directions [Dong 2011 §4.3.2]: visibility without a map.
 *
 * Each leaf walks the tree by itself, from the root: a node is opened while its solid angle exceeds the bin's. The bits
 * depend on neither order nor threads. The thesis links nodes with each other, refines and pushes the links to the leaves:
 * links_desc.pairs.
 *
 * The thesis has a partner fill the bin of its middle alone. Near partners then leave bins empty beside it, through which
 * light leaks. LINKS_COVER_DISK fills all bins whose middle ray meets the partner's disk. The weight of a link is the cosine
 * over its bin, as the thesis says that a partner covers it; eq. 4.5 takes the partner's own solid angle
 * (LINKS_WEIGHT_ELEMENT), which loses half of the light. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_LINKS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_LINKS_H

#include "techniques/implicit-visibility/bins.h"
#include "techniques/implicit-visibility/tree.h"

enum links_cover { LINKS_COVER_DISK, LINKS_COVER_CENTER };
enum links_weight { LINKS_WEIGHT_BIN, LINKS_WEIGHT_ELEMENT };

struct links_desc {
    int side; /* n */
    enum links_cover cover;
    enum links_weight weight;
    bool turned; /* each leaf has turned its bins at random: no bands, but noise */
    bool leaky;  /* empty bins among filled ones stay empty */
    bool
        pairs; /* by pairs of nodes (pairs.h), in bins of the world, each partner in its middle's */
    int threads; /* 0: all cores */
};

enum { LINK_BIN_BITS = 13, LINK_NODE_BITS = 32 - LINK_BIN_BITS };

struct link {
    uint32_t node : LINK_NODE_BITS, bin : LINK_BIN_BITS;
    vec3s weight; /* what it adds of the node's radiance to the irradiance, sr, through panes */
};

struct links {
    struct links_desc desc;
    const struct bvh *panes; /* they dim what comes along links; NULL: none */
    float clearance;         /* of leaves, which may lie on one, m */
    struct bins bins;
    int leaf_count, stride;
    struct link *items; /* stride of each leaf: its links, and from the end on its empty bins */
    int *counts;        /* of each leaf's links */
    int *open_counts;   /* of its empty bins, which see the sky; their node means nothing */
    int *lamp_counts;   /* its first so many lead to lamps: its list of light links */
    float *filled;      /* share of each leaf's cosine whose bins have a partner, front or back */
    float *buried;   /* the same, with backs: a leaf that sees little else lies within something */
    long linked;     /* by pairs: ends of links between nodes, before the push */
    float (*sky)[3]; /* irradiance through the empty bins */
};

/* For so many leaves. Error: out of memory; links_free is then allowed. */
bool links_init(struct links *links, const struct links_desc *desc, int leaf_count);
void links_free(struct links *links);

/* Links all leaves. sky: radiance of each bin; NULL: none. */
void links_make(struct links *links, const struct tree *tree, const float (*sky)[3]);

/* Puts links to nodes that emit before all others of each leaf [Dong 2011 §4.3.3]. Radiance of nodes; NULL: none emits. */
void links_sort_lamps(struct links *links, const float (*emission)[4]);

/* From a leaf's bins to the world. */
mat3s links_to_world(const struct links *links, int leaf);

/* How many links and empty bins a leaf may have. */
int links_stride(int side);

size_t links_bytes(const struct links *links);

/* Irradiance of a leaf by the values of the tree's nodes: of all its links, or of those to lamps. */
vec3s links_gather(const struct links *links, int leaf, const float (*radiance)[4]);
vec3s links_gather_lamps(const struct links *links, int leaf, const float (*emission)[4]);

#endif
