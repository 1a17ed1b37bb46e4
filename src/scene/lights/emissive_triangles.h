/* Triangles of emissive surfaces in the world, one by one, for surfaces that lights only stand in
 * for. A light tree samples them (scene/lights/light_tree.h, light_bounds_of_triangle). Cost: up to
 * 4096 texels for a textured triangle. */
#ifndef SCENE_LIGHTS_EMISSIVE_TRIANGLES_H
#define SCENE_LIGHTS_EMISSIVE_TRIANGLES_H

#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

struct light_triangle;

/* Origin of a triangle. */
struct emissive_place {
    uint32_t triangle; /* of the geometry */
    bool is_back;      /* emits from its back */
};

struct emissive_triangles {
    struct light_triangle *items; /* glsl/shared/light_tree.h; ready for a GPU */
    struct emissive_place *places;
    int count;
};

/* Lists the emitting triangles, without dark ones, of all surfaces whose stand-ins are among the
 * emitters. A double-sided triangle is in the list twice, the back after the front. */
void emissive_triangles_init(struct emissive_triangles *list, const struct scene *scene,
                             const struct geometry *geometry, const struct emitters *emitters);

/* Accepts a zeroed object. */
void emissive_triangles_free(struct emissive_triangles *list);

#endif
