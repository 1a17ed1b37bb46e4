/* Light of surface elements: direct light by rays, then bounces along the links [Dong 2011 §4.3.3]. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_LIGHT_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_LIGHT_H

#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"
#include "scene/mesh/bvh.h"
#include "techniques/implicit-visibility/lamps.h"
#include "techniques/implicit-visibility/links.h"

struct element_light {
    int count, node_count;
    float (*direct)[3];     /* irradiance of lights, W/m2 */
    float (*radiance)[4];   /* leaving each node of the tree, W/(sr m2) */
    float (*irradiance)[3]; /* indirect, of each leaf, W/m2 */
    float (*emission)[4];   /* of each node, W/(sr m2), dimmed; NULL: none emits */
};

void element_light_init(struct element_light *light, const struct tree *tree);
void element_light_free(struct element_light *light);

/* Lets the elements of lamps emit, in their places of the tree, where there are any. */
void element_light_emit(struct element_light *light, const struct elements *elements,
                        const struct tree *tree);

/* Scales the emission of each lamp's elements by the lamp's share. */
void element_light_dim(struct element_light *light, const struct elements *elements,
                       const struct tree *tree, const struct lamps *lamps);

/* Trees of the geometry's triangles for element_light_direct: with alpha masks, and panes; bvh_free them. */
void element_light_casters(struct bvh *casters, struct bvh *panes, const struct scene *scene,
                           const struct geometry *geometry);

/* Mean radiance of the environment in each bin; free() it. */
float (*element_light_sky(const struct bins *bins, const struct environment *environment))[3];

struct direct_lights {
    const struct emitter *items; /* as if without a size */
    int count;
    bool lamps_by_links; /* lamps that are surfaces shine by light->emission along the links */
    const struct bvh *casters, *panes;
    float clearance; /* geometry_clearance */
};

/* Fills light->direct; the links' sky is added if there is one. */
void element_light_direct(struct element_light *light, const struct elements *elements,
                          const struct direct_lights *lights, const struct links *links);

/* Fills light->irradiance with that many bounces of light->direct, one at least: each gathers what all
 * before it reflect (Jacobi). */
void element_light_bounce(struct element_light *light, const struct elements *elements,
                          const struct tree *tree, const struct links *links, int bounces);

#endif
