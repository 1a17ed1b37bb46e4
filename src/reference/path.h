/* Traces one path from a surface to the light. */
#ifndef REFERENCE_PATH_H
#define REFERENCE_PATH_H

#include "reference/light_vertices.h"

struct path_scene {
    const struct ray_scene *rays;
    const struct emission *emission;
    int bounces;
};

/* Returns an estimate of the light that x reflects over 1 to `bounces` bounces. diffuse: irradiance
 * over pi. lights: vertices of the sampler's stream. */
struct reflected path_indirect(const struct path_scene *scene, const struct light_vertices *lights,
                               const struct hit *x, struct sampler *sampler);

#endif
