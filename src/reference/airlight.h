/* Estimates airlight: single scattering in a medium, from the lights towards the camera. */
#ifndef REFERENCE_AIRLIGHT_H
#define REFERENCE_AIRLIGHT_H

#include "reference/scene/emission.h"

/* Returns the radiance that emission->medium scatters along a ray of `length` metres. It is the
 * mean over `count` samplers, each with a point of the ray and a shadow ray to each light. Points
 * are equiangular about the light [Kulla and Fajardo 2012], denser for a greater phase function. */
vec3s airlight_along(const struct emission *emission, const struct ray_scene *rays, vec3s origin,
                     vec3s direction, float length, const struct sampler *samplers, int count);

#endif
