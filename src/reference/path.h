/* One path from a surface to the light. */
#ifndef REFERENCE_PATH_H
#define REFERENCE_PATH_H

#include "reference/emitter.h"
#include "reference/sampler.h"

/* An estimate of the light that reaches x over 1 to `bounces` bounces, as irradiance over pi. */
vec3s path_indirect(const struct ray_scene *rays, const struct emitter *emitter, int bounces,
                    const struct hit *x, struct sampler *sampler);

#endif
