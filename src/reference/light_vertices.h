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

#include "reference/scene/emission.h"
#include "reference/sampler.h"

enum { LIGHT_VERTEX_COUNT = 1 << 16 };

struct light_vertex {
    vec3s position, normal; /* geometric, on the light's side */
    vec3s radiance;         /* reflected, W/(sr m2) */
    float density;          /* of light rays there, 1/m2; 0 where none is reflected */
    float cosine;           /* struct arrival's */
};

/* Traces the emission's LIGHT_VERTEX_COUNT rays on some threads (0 = all cores); free() frees. */
struct light_vertex *light_vertices_trace(const struct emission *emission,
                                          const struct ray_scene *rays, uint32_t seed, int threads);

#endif
