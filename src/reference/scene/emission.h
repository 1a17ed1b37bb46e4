/* The lights as a path tracer needs them: what reaches a surface, and rays that start from them. */
#ifndef REFERENCE_SCENE_EMISSION_H
#define REFERENCE_SCENE_EMISSION_H

#include "base/deal.h"
#include "reference/sampler.h"
#include "reference/scene/ray_scene.h"
#include "scene/emitter.h"

struct source {
    struct emitter light;
    float solid_angle; /* spot and point: of the cone, sr */
    float share;       /* of all light rays: those that start from it */
};

struct emission {
    struct source *sources;
    int count;
    bool has_sizes;     /* some light has a size: places on lights are to be drawn */
    struct dealt *rays; /* from which light each light ray starts: as many as it has flux */
    vec3s center;       /* of the scene's bounding sphere */
    float radius;       /* the same sphere's, m */
};

/* A light as it reaches a surface from one place of its own when nothing is between: places are two
 * numbers in [0, 1), and a light without a size is the same from all. irradiance is what the whole
 * light would give if all were as this place, over the density with which emission_place picks it;
 * density is over the same. */
struct arrival {
    vec3s at;         /* a point towards the light beyond which nothing can block */
    vec3s irradiance; /* by the shading normal, W/m2 */
    float density;    /* of light rays on the surface, 1/m2 */
};

/* With so many light rays, or none. */
void emission_init(struct emission *emission, const struct emitters *emitters,
                   const struct geometry *geometry, int ray_count);

/* Accepts zeroed ones. */
void emission_free(struct emission *emission);

/* A place of the n-th light picked for this surface: of a rectangle by solid angle, of a sphere on the
 * side that it sees. */
vec2s emission_place(const struct emission *emission, int n, vec2s sample, const struct hit *hit);

/* The n-th light alone, from that place. False where it cannot arrive: outside the cone, or from
 * behind. */
bool emission_reach(const struct emission *emission, int n, vec2s place, const struct hit *hit,
                    struct arrival *arrival);

/* The radiance that the surface reflects of what arrives. */
vec3s emission_reflected(const struct hit *hit, const struct arrival *arrival);

/* What a Lambertian surface of albedo 1 would reflect of all lights: irradiance over pi,
 * W/(sr m2). Traces the shadow rays: one for a light without a size, and for others as many as
 * there are samplers. */
vec3s emission_direct(const struct emission *emission, const struct ray_scene *rays,
                      const struct hit *hit, const struct sampler *samplers, int count);

/* Where a ray of the n-th light meets the scene first; false where it misses. The ray is picked by a
 * place and two numbers more in [0, 1): uniform in the solid angle of a spot or a point, in the
 * cosine of an area light, in the bounding sphere's cross section for a directional light. */
bool emission_first_hit(const struct emission *emission, int n, const struct ray_scene *rays,
                        vec2s place, vec2s sample, struct hit *hit);

#endif
