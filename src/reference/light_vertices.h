/* First hits of light rays: vertices that many paths share, as the virtual point lights of [Keller
 * 1997, Instant Radiosity].
 *
 * There are enough that each path takes another one, weighted so that none stands out. Each stream
 * of samples has its own vertices, so streams stay independent. A pixel's walk through them is
 * shifted by its own random bits. Pixels with more paths than vertices reuse some, without bias,
 * but do not converge below about 0.01 % noise. Each run of vertices has all lights in proportion
 * to their flux. */
#ifndef REFERENCE_LIGHT_VERTICES_H
#define REFERENCE_LIGHT_VERTICES_H

#include "reference/sampler.h"
#include "reference/scene/emission.h"

enum { LIGHT_VERTEX_COUNT = 1 << 16 };

struct light_vertex {
    vec3s position, normal; /* geometric normal, on the light's side */
    vec3s radiance;         /* reflected by a Lambertian surface, W/(sr m2) */
    float density;          /* density of light rays there, 1/m2; 0: reflects none */
    float chosen;           /* how often its light is chosen there on average */
    float found;            /* as in struct arrival */
    bool diffuse;           /* else the reflection is in a light_specular */
};

/* A vertex with view-dependent reflection: surface and arriving light. */
struct light_specular {
    struct hit hit;
    struct arrival arrival;
};

struct light_vertices {
    struct light_vertex *items;
    struct light_specular *specular; /* one a vertex; NULL if all surfaces are diffuse */
};

/* Traces the emission's LIGHT_VERTEX_COUNT rays. threads 0: all cores. The caller calls
 * light_vertices_free. */
struct light_vertices light_vertices_trace(const struct emission *emission,
                                           const struct ray_scene *rays, uint32_t seed,
                                           int threads);

/* Accepts a zeroed object. */
void light_vertices_free(struct light_vertices *vertices);

#endif
