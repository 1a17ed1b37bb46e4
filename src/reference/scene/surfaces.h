/* Emissive surfaces as a path tracer needs them: points picked by how much light leaves there, a triangle
 * at a time, and how likely they are. */
#ifndef REFERENCE_SCENE_SURFACES_H
#define REFERENCE_SCENE_SURFACES_H

#include "reference/alias.h"
#include "reference/scene/hit.h"
#include "scene/lights/emitter.h"

struct surfaces {
    const struct hit_table *table;
    bool *shines; /* each triangle of the scene's: it is of a lamp that shines; NULL: none does */
    int *
        first; /* each triangle's first in the list, of which a double-sided one has two; -1 = it is
                     a light for itself, or does not shine; NULL: all are */
    struct surface_triangle {
        uint32_t triangle;
        bool back;
        float density; /* with which its points are picked, 1/m2 */
    } * list;
    int count;
    struct alias alias; /* of the list */
    double flux;        /* over pi, the mean of RGB, W */
};

/* Those of the scene's surfaces whose lamps are among the emitters; in the list where those only stand in
 * for them. */
void surfaces_init(struct surfaces *surfaces, const struct hit_table *table,
                   const struct emitters *emitters);

/* Accepts zeroed ones. */
void surfaces_free(struct surfaces *surfaces);

/* The area light that the whole list is on average, from the point that two numbers in [0, 1) pick; with
 * which density they do, 1/m2. */
struct emitter surfaces_piece(const struct surfaces *surfaces, const float place[2],
                              double *density);

/* The density with which a point that a ray met is picked; 0: it is of none in the list. */
float surfaces_density(const struct surfaces *surfaces, const struct hit *hit);

/* What the camera sees of a surface's own light. */
vec3s surfaces_glow(const struct surfaces *surfaces, const struct hit *hit);

#endif
