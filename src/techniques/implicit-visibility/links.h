/* Links surface elements to their nearest partner in each bin of directions: visibility without a
 * map [Dong 2011 §4.3.2].
 *
 * Each leaf walks the tree from the root and opens nodes whose solid angle exceeds the bin's.
 * Results do not depend on order or threads. The thesis links nodes, refines, and pushes links to
 * the leaves: links_desc.pairs.
 *
 * In the thesis a partner fills only the bin of its centre, so near partners leave empty bins
 * through which light leaks. LINKS_COVER_DISK fills all bins whose central ray meets the partner's
 * disk. A link's weight is the cosine integrated over its bin, as the thesis describes. Eq. 4.5
 * takes the partner's own solid angle (LINKS_WEIGHT_ELEMENT), which loses half of the light. */
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
    bool turned; /* rotates the bins of each leaf at random: noise in place of bands */
    bool leaky;  /* keeps empty bins among filled ones */
    /* Links by pairs of nodes (pairs.h), in world bins, each partner in the bin of its centre. */
    bool pairs;
    int threads; /* 0: all cores */
};

enum { LINK_BIN_BITS = 13, LINK_NODE_BITS = 32 - LINK_BIN_BITS };

struct link {
    uint32_t node : LINK_NODE_BITS, bin : LINK_BIN_BITS;
    vec3s weight; /* irradiance per radiance of the node, sr, dimmed by panes */
};

struct links {
    struct links_desc desc;
    const struct bvh *panes; /* panes that dim light along links; NULL: none */
    float clearance;         /* distance of rays from leaves, which may be on a pane, m */
    struct bins bins;
    int leaf_count, stride;
    struct link *items; /* `stride` a leaf: its links from the start, its empty bins from the end */
    int *counts;        /* number of each leaf's links */
    /* Number of each leaf's empty bins, which see the environment; their node is unused. */
    int *open_counts;
    /* Number of each leaf's links to lamps, which come first: its list of light links. */
    int *lamp_counts;
    float *filled;   /* fraction of each leaf's cosine in bins with a partner, front or back */
    float *buried;   /* fraction with backs; a leaf with a high value is inside an object */
    long linked;     /* with pairs: ends of links between nodes, before the push */
    float (*sky)[3]; /* irradiance through the empty bins */
};

/* Makes room for leaf_count leaves. Error: out of memory; links_free is still allowed. */
bool links_init(struct links *links, const struct links_desc *desc, int leaf_count);
void links_free(struct links *links);

/* Links all leaves. sky: radiance of each bin; NULL: none. */
void links_make(struct links *links, const struct tree *tree, const float (*sky)[3]);

/* Sorts each leaf's links to emitting nodes first [Dong 2011 §4.3.3]. emission: of the nodes;
 * NULL: none emits. */
void links_sort_lamps(struct links *links, const float (*emission)[4]);

/* Returns the rotation from a leaf's bins to the world. */
mat3s links_to_world(const struct links *links, int leaf);

/* Returns the most links and empty bins of a leaf, for bins of `side`. */
int links_stride(int side);

/* Return the irradiance of a leaf from node values: over all links, or over links to lamps. */
vec3s links_gather(const struct links *links, int leaf, const float (*radiance)[4]);
vec3s links_gather_lamps(const struct links *links, int leaf, const float (*emission)[4]);

#endif
