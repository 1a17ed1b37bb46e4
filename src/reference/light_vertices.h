/* Where rays of light first meet the scene: vertices that many paths share.
 *
 * They are the virtual point lights of [Keller 1997, Instant Radiosity], but so many that each path
 * takes another one, and weighted so that none stands out. A stream of samples has vertices of its
 * own, so that streams stay independent; a pixel's walk through them is shifted by its own random
 * bits. A pixel that takes more paths than there are vertices sees some again, which costs it no
 * bias, only convergence beyond some 0.01 % of noise. Each light has as many as its share of the
 * flux, dealt so that every run of vertices has some of all.
 */
#ifndef REFERENCE_LIGHT_VERTICES_H
#define REFERENCE_LIGHT_VERTICES_H

#include "reference/sampler.h"
#include "reference/scene/emission.h"

enum { LIGHT_VERTEX_COUNT = 1 << 16 };

struct light_vertex {
    vec3s position, normal; /* geometric, on the light's side */
    vec3s radiance;         /* reflected by a Lambertian surface, W/(sr m2) */
    float density;          /* of light rays there, 1/m2; 0 where none is reflected */
    float found;            /* struct arrival's */
    bool diffuse;           /* else what it reflects is in a light_specular */
};

/* Of a vertex that reflects otherwise to everyone: the surface and what comes to it. */
struct light_specular {
    struct hit hit;
    struct arrival arrival;
};

struct light_vertices {
    struct light_vertex *items;
    struct light_specular *specular; /* of each; NULL where all surfaces are diffuse */
};

/* Traces the emission's LIGHT_VERTEX_COUNT rays on some threads (0 = all cores). */
struct light_vertices light_vertices_trace(const struct emission *emission,
                                           const struct ray_scene *rays, uint32_t seed,
                                           int threads);

/* Accepts zeroed ones. */
void light_vertices_free(struct light_vertices *vertices);

#endif
