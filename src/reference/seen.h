/* What soft shadows are made of: the direct light that there would be if nothing hid the lights, and the share
 * of the lights that is seen. */
#ifndef REFERENCE_SEEN_H
#define REFERENCE_SEEN_H

#include "reference/scene/emission.h"

/* The share is unweighted: of the area of a light (of a sun solid angle, of emissive surfaces and the sky the light
 * that leaves there) which the surface faces and which faces it, what nothing hides. Shares of several
 * lights are weighted by what each would give from its middle. */
struct seen {
    vec3s unshadowed;   /* irradiance over pi, W/(sr m2) */
    vec3s visible, all; /* the share is one over the other */
};

/* Traces a shadow ray for each light without a size, and for others as many as there are samplers. */
struct seen seen_from(const struct emission *emission, const struct ray_scene *rays,
                      const struct hit *hit, const struct sampler *samplers, int count);

#endif
