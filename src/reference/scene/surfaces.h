/* Emissive surfaces for the path tracer: samples points by their emission, triangle by triangle. */
#ifndef REFERENCE_SCENE_SURFACES_H
#define REFERENCE_SCENE_SURFACES_H

#include "reference/alias.h"
#include "reference/scene/hit.h"
#include "scene/lights/emitter.h"

struct surfaces {
    const struct hit_table *table;
    bool *shines; /* for each triangle: belongs to a shining lamp; NULL: none does */
    /* First item of each triangle in the list; double-sided ones have two. -1: a light of its own,
     * or dark. NULL: all are. */
    int *first;
    struct surface_triangle {
        uint32_t triangle;
        bool back;
        float density; /* density of its points, 1/m2 */
    } * list;
    int count;
    struct alias alias; /* over the list */
    double flux;        /* over pi, mean of RGB, W */
};

/* Finds the scene's surfaces whose lamps are among the emitters. The list has those that emitters
 * only approximate. */
void surfaces_init(struct surfaces *surfaces, const struct hit_table *table,
                   const struct emitters *emitters);

/* Accepts a zeroed object. */
void surfaces_free(struct surfaces *surfaces);

/* Returns an area light for two numbers in [0, 1); its mean is the whole list. density: of its
 * point, 1/m2. */
struct emitter surfaces_piece(const struct surfaces *surfaces, const float place[2],
                              double *density);

/* Returns the density of a hit point, 1/m2; 0: not in the list. */
float surfaces_density(const struct surfaces *surfaces, const struct hit *hit);

/* Returns the emission that the camera sees, W/(sr m2). */
vec3s surfaces_glow(const struct surfaces *surfaces, const struct hit *hit);

#endif
