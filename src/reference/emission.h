/* The light as a path tracer needs it: what reaches a surface, and rays that start from it. */
#ifndef REFERENCE_EMISSION_H
#define REFERENCE_EMISSION_H

#include "reference/ray_scene.h"
#include "scene/emitter.h"

struct emission {
    struct emitter light;
    float solid_angle; /* spot and point: of the cone, sr */
    vec3s center;      /* directional: of the scene's bounding sphere */
    float radius;      /* the same sphere's, m */
};

/* The light as it reaches a surface when nothing is between. */
struct arrival {
    vec3s source;     /* a point towards the light beyond which nothing can block */
    vec3s irradiance; /* by the shading normal, W/m2 */
    float density;    /* of emission_first_hit on the surface, 1/m2 */
};

struct emission emission_of(const struct emitter *light, const struct geometry *geometry);

/* False where no light can arrive: outside the cone, or from behind. */
bool emission_reach(const struct emission *emission, const struct hit *hit,
                    struct arrival *arrival);

/* The radiance that the surface reflects of what arrives. */
vec3s emission_reflected(const struct hit *hit, const struct arrival *arrival);

/* What a Lambertian surface of albedo 1 would reflect: irradiance over pi, W/(sr m2). Traces the
 * shadow ray. */
vec3s emission_direct(const struct emission *emission, const struct ray_scene *rays,
                      const struct hit *hit);

/* Where a ray of light meets the scene first; false where it misses. The ray is picked by two
 * numbers in [0, 1): uniform in the solid angle of a spot or a point, in the bounding sphere's
 * cross section for a directional light. */
bool emission_first_hit(const struct emission *emission, const struct ray_scene *rays, vec2s sample,
                        struct hit *hit);

#endif
