/* Lights surface elements: direct light by rays, then bounces along the links [Dong 2011
 * §4.3.3]. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_LIGHT_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_LIGHT_H

#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"
#include "scene/mesh/bvh.h"
#include "techniques/implicit-visibility/lamps.h"
#include "techniques/implicit-visibility/links.h"

struct element_light {
    int count, node_count;
    float (*direct)[3];     /* irradiance by lights, W/m2 */
    float (*radiance)[4];   /* radiance of each node of the tree, W/(sr m2) */
    float (*irradiance)[3]; /* indirect irradiance of each leaf, W/m2 */
    float (*emission)[4];   /* emission of each node, W/(sr m2), dimmed; NULL: none emits */
};

void element_light_init(struct element_light *light, const struct tree *tree);
void element_light_free(struct element_light *light);

/* Sets the emission of lamps' elements in tree order, if there are lamps. */
void element_light_emit(struct element_light *light, const struct elements *elements,
                        const struct tree *tree);

/* Scales the emission of each lamp's elements by the lamp's fraction. */
void element_light_dim(struct element_light *light, const struct elements *elements,
                       const struct tree *tree, const struct lamps *lamps);

/* Builds BVHs of the geometry's triangles for element_light_direct: with alpha masks, and of panes.
 * The caller frees both by bvh_free. */
void element_light_casters(struct bvh *casters, struct bvh *panes, const struct scene *scene,
                           const struct geometry *geometry);

/* Returns the mean radiance of the environment in each bin, W/(sr m2). The caller frees it. */
float (*element_light_sky(const struct bins *bins, const struct environment *environment))[3];

struct direct_lights {
    const struct emitter *items; /* lights, treated as points */
    int count;
    bool lamps_by_links; /* emissive surfaces emit along the links by light->emission */
    const struct bvh *casters, *panes;
    float clearance; /* geometry_clearance */
};

/* Fills light->direct, plus the links' environment light if there is one. */
void element_light_direct(struct element_light *light, const struct elements *elements,
                          const struct direct_lights *lights, const struct links *links);

/* Fills light->irradiance with `bounces` bounces of light->direct, at least one. Each bounce
 * gathers the reflected light of all previous ones (Jacobi iteration). */
void element_light_bounce(struct element_light *light, const struct elements *elements,
                          const struct tree *tree, const struct links *links, int bounces);

#endif
