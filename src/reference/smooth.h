/* Glass and mirrors: the next ray at an interface, and its fraction of the light.
 *
 * Glass has Fresnel's unpolarised reflectance [Dong 2011, eqs. 2.12 to 2.14] and refracts by
 * Snell's law. A random number chooses one direction with the reflectance as probability, so the
 * light keeps its amount. As in glTF, the base colour tints light at an interface, and absorption
 * light inside. Thin walls pass light straight; their reflectance includes reflections between both
 * interfaces. Mirrors reflect their base colour at all angles. Neither is rough. Vertex normals
 * bend the light; the triangle's side decides whether it enters. Each interface has air on its
 * other side, also in nested glass. Radiance is not scaled by the squared index of refraction. */
#ifndef REFERENCE_SMOOTH_H
#define REFERENCE_SMOOTH_H

#include "reference/scene/ray_scene.h"

/* Most interfaces of a chain. */
enum { SMOOTH_MOST = 32 };

/* Returns the reflectance of an interface by the cosine of the angle of incidence; 1 is total
 * reflection. from_to: index of refraction on the incoming side over that on the other side. */
float smooth_reflectance(float cosine, float from_to);

/* Refracts a unit direction; the unit normal is on its incoming side. False: total reflection. */
bool smooth_refract(vec3s direction, vec3s normal, float from_to, vec3s *refracted);

struct smooth_ray {
    vec3s origin, direction;
    vec3s share;                   /* fraction of the incoming light */
    const struct material *inside; /* glass around the ray; NULL: none */
};

/* Returns the ray that leaves the interface. pick: random number in [0, 1). */
struct smooth_ray smooth_leave(const struct ray_scene *rays, const struct hit *hit, float pick);

/* Returns the glass around a ray when it met the surface. inside: the glass that was expected. */
const struct material *smooth_inside(const struct hit *hit, const struct material *inside);

/* Returns the transmittance of `length` metres of glass; infinite where an open mesh has no
 * back. */
vec3s smooth_passes(const struct material *glass, float length);

#endif
