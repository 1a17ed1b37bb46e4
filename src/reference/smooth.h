/* Glass and mirrors: where a ray goes on that meets one, and the share of its light that does.
 *
 * Glass has Fresnel's reflectance for light without polarisation [Dong 2011, eqs. 2.12 to 2.14], and refracts by Snell's
 * law. A number picks one of the two directions, with the reflectance as its probability: the light keeps its amount.
 * The base colour tints light that passes an interface, and absorption light within, as glTF has them. Thin walls let
 * light go straight on; their reflectance is that of both interfaces, with all reflections between them. A mirror
 * reflects its base colour at all angles. Neither is rough.
 *
 * The vertices' normals bend the light; the triangle's side tells whether it enters or leaves. Each interface has air on
 * its other side, in nested glass, too. Radiance is not scaled by the square of the index of refraction.
 */
#ifndef REFERENCE_SMOOTH_H
#define REFERENCE_SMOOTH_H

#include "reference/scene/ray_scene.h"

/* Longer chains of interfaces are cut. */
enum { SMOOTH_MOST = 32 };

/* The reflectance of an interface, for the cosine of the angle of incidence; from_to: index of refraction where the
 * light comes from over that where it goes. 1 = total reflection. */
float smooth_reflectance(float cosine, float from_to);

/* Both unit, the normal on the side that the light comes from; false: total reflection. */
bool smooth_refract(vec3s direction, vec3s normal, float from_to, vec3s *refracted);

struct smooth_ray {
    vec3s origin, direction;
    vec3s share;                   /* of the light that came */
    const struct material *inside; /* the glass that it goes through; NULL = none */
};

/* The ray that leaves such a surface; pick: in [0, 1). */
struct smooth_ray smooth_leave(const struct ray_scene *rays, const struct hit *hit, float pick);

/* The glass that a ray was in when it met the surface, if `inside` is where it was thought to be. */
const struct material *smooth_inside(const struct hit *hit, const struct material *inside);

/* The share of light that passes so many metres of the glass; infinite where an open mesh has no back. */
vec3s smooth_passes(const struct material *glass, float length);

#endif
