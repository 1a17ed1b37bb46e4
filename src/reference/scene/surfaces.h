/* Emissive surfaces for the path tracer: samples points by their emission, triangle by triangle. */
#ifndef REFERENCE_SCENE_SURFACES_H
#define REFERENCE_SCENE_SURFACES_H

#include "reference/alias.h"
#include "reference/scene/hit.h"
#include "scene/lights/light_tree.h"

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
    /* Over the list, if it has more than SURFACES_BY_POWER_MAX; else empty. Surfaces then sample
     * its places. */
    struct light_tree tree;
    double flux; /* over pi, mean of RGB, W */
};

enum { SURFACES_BY_POWER_MAX = 4096 };

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

/* Returns an area light for three numbers in [0, 1), by the tree; its mean is the list's light at
 * the surface. False: none. densities: of the point by the tree and by surfaces_piece, 1/m2. */
bool surfaces_piece_near(const struct surfaces *surfaces, const struct hit *from, vec3s place,
                         struct emitter *piece, double densities[2]);

/* Writes these densities of a hit point, which are equal without a tree. False: not in the list. */
bool surfaces_densities(const struct surfaces *surfaces, const struct hit *from,
                        const struct hit *hit, double densities[2]);

/* Returns how often the tree samples the point of surfaces_piece over how often this does; 1: no
 * tree. */
float surfaces_chosen(const struct surfaces *surfaces, const struct hit *from,
                      const float place[2]);

/* Returns the emission that the camera sees, W/(sr m2). */
vec3s surfaces_glow(const struct surfaces *surfaces, const struct hit *hit);

#endif
