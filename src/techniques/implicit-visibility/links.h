/* Links of surface elements to their nearest partner in each bin of directions [Dong 2011 §4.3.2]: visibility without a map.
 *
 * Each leaf walks the tree by itself, from the root: a node is opened while its solid angle exceeds the bin's. The thesis
 * links nodes with each other, refines and pushes the links to the leaves; that ends with nearly the same links, but
 * depends on the order. Here the bits depend on neither order nor threads.
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
    int threads; /* 0: all cores */
};

struct link {
    uint32_t node;
    float weight; /* what it adds of the node's radiance to the irradiance, sr */
};

struct links {
    struct links_desc desc;
    struct bins bins;
    int leaf_count, stride;
    struct link *items; /* stride of each leaf */
    int *counts;        /* of each leaf's links */
    float *filled;      /* share of each leaf's cosine whose bins have a partner, front or back */
    float *buried;   /* the same, with backs: a leaf that sees little else lies within something */
    float (*sky)[3]; /* irradiance through the empty bins */
};

/* For so many leaves. Error: out of memory; links_free is then allowed. */
bool links_init(struct links *links, const struct links_desc *desc, int leaf_count);
void links_free(struct links *links);

/* Links all leaves. sky: radiance of each bin; NULL: none. */
void links_make(struct links *links, const struct tree *tree, const float (*sky)[3]);

size_t links_bytes(const struct links *links);

/* Irradiance of a leaf by the values of the tree's nodes. */
vec3s links_gather(const struct links *links, int leaf, const float (*radiance)[4]);

#endif
