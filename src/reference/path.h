/* One path from a surface to the light. */
#ifndef REFERENCE_PATH_H
#define REFERENCE_PATH_H

#include "reference/light_vertices.h"

struct path_scene {
    const struct ray_scene *rays;
    const struct emission *emission;
    int bounces;
};

/* An estimate of the light that reaches x over 1 to `bounces` bounces, as irradiance over pi.
 * lights: the vertices of the sampler's stream. */
vec3s path_indirect(const struct path_scene *scene, const struct light_vertex *lights,
                    const struct hit *x, struct sampler *sampler);

#endif
