/* Data of soft shadows: unshadowed direct light, and the visible fraction of the lights. */
#ifndef REFERENCE_SEEN_H
#define REFERENCE_SEEN_H

#include "reference/scene/emission.h"

/* The visible fraction is unweighted: of the light's area that faces the surface and is faced by
 * it. For a sun it is of solid angle; for emissive surfaces and the environment of emission.
 * Several lights are weighted by the unshadowed light from their centres. */
struct seen {
    vec3s unshadowed;   /* irradiance over pi, W/(sr m2) */
    vec3s visible, all; /* fraction = visible / all */
};

/* Traces one shadow ray to each point light, `count` to others. */
struct seen seen_from(const struct emission *emission, const struct ray_scene *rays,
                      const struct hit *hit, const struct sampler *samplers, int count);

#endif
