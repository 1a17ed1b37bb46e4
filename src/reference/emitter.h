/* The light as a path tracer needs it: what reaches a surface, and rays that start from it. */
#ifndef REFERENCE_EMITTER_H
#define REFERENCE_EMITTER_H

#include "reference/ray_scene.h"
#include "scene/light.h"

struct emitter {
    struct light light;
    float solid_angle; /* spot and point: of the cone, sr */
    vec3s center;      /* directional: of the scene's bounding sphere */
    float radius;      /* the same sphere's, m */
};

/* The light as it reaches a surface when nothing is between. */
struct arrival {
    vec3s source;     /* a point towards the light beyond which nothing can block */
    vec3s irradiance; /* by the shading normal, W/m2 */
    float density;    /* of emitter_first_hit on the surface, 1/m2 */
};

struct emitter emitter_of(const struct light *light, const struct geometry *geometry);

/* False where no light can arrive: outside the cone, or from behind. */
bool emitter_reach(const struct emitter *emitter, const struct hit *hit, struct arrival *arrival);

/* The radiance that the surface reflects of what arrives. */
vec3s emitter_reflected(const struct hit *hit, const struct arrival *arrival);

/* What a Lambertian surface of albedo 1 would reflect: irradiance over pi, W/(sr m2). Traces the
 * shadow ray. */
vec3s emitter_direct(const struct emitter *emitter, const struct ray_scene *rays,
                     const struct hit *hit);

/* Where a ray of light meets the scene first; false where it misses. The ray is picked by two
 * numbers in [0, 1): uniform in the solid angle of a spot or a point, in the bounding sphere's
 * cross section for a directional light. */
bool emitter_first_hit(const struct emitter *emitter, const struct ray_scene *rays, vec2s sample,
                       struct hit *hit);

#endif
