/* Airlight: light that a medium scatters once, from the lights towards the eye. */
#ifndef REFERENCE_AIRLIGHT_H
#define REFERENCE_AIRLIGHT_H

#include "reference/scene/emission.h"

/* Of a ray, so long, through emission->medium: radiance, the mean over samplers, each with a point of the ray and a
 * shadow ray for each light. Points are picked by angle as seen from the light [Kulla and Fajardo 2012], denser where
 * the phase function is greater. */
vec3s airlight_along(const struct emission *emission, const struct ray_scene *rays, vec3s origin,
                     vec3s direction, float length, const struct sampler *samplers, int count);

#endif
