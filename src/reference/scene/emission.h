/* The lights as a path tracer needs them: what reaches a surface, and rays that start from them. */
#ifndef REFERENCE_SCENE_EMISSION_H
#define REFERENCE_SCENE_EMISSION_H

#include "base/deal.h"
#include "reference/sampler.h"
#include "reference/scene/medium_ball.h"
#include "reference/scene/ray_scene.h"
#include "reference/scene/sky.h"
#include "reference/scene/surfaces.h"
#include "scene/lights/emitter.h"

enum source_kind { SOURCE_LIGHT, SOURCE_SURFACES, SOURCE_SKY };

struct source {
    enum source_kind kind;
    struct emitter light; /* SOURCE_LIGHT */
    float solid_angle;    /* spot and point: of the cone, sr */
    float share;          /* of all light rays: those that start from it */
};

struct emission {
    struct source *sources;
    int count;
    struct surfaces surfaces;
    struct sky sky;
    int surfaces_number, sky_number; /* of the sources that these are; -1 = none */
    bool has_sizes;                  /* some light has a size: places on lights are to be drawn */
    bool has_found;                  /* rays of diffuse surfaces may come to one by chance */
    struct dealt *rays; /* from which light each light ray starts: as many as it has flux */
    struct medium_ball medium;
    vec3s center; /* of the scene's bounding sphere */
    float radius; /* the same sphere's, m */
};

/* A light as it reaches a surface from one place of its own when nothing is between: places are two
 * numbers in [0, 1), and a light without a size is the same from all. irradiance is what the whole
 * light would give if all were as this place, over the density with which emission_place picks it, and what of that
 * passes the medium; density is over the same. */
struct arrival {
    vec3s at;         /* a point towards the light beyond which nothing can block */
    vec3s direction;  /* unit: to the light */
    vec3s irradiance; /* by the shading normal, W/m2 */
    float density;    /* of light rays on the surface, 1/m2 */
    float picked; /* the density with which emission_place picks it, 1/sr; 0 where rays that leave
                         the surface by its reflection cannot come to it */
    float found;  /* the density with which they do, over that */
};

/* With so many light rays, or none. table, which must live on, has the emissive surfaces; NULL: what stands
 * in for them is taken for lights. A black sky is no source. Without a medium, which may be set afterwards. */
void emission_init(struct emission *emission, const struct emitters *emitters,
                   const struct geometry *geometry, const struct hit_table *table, int ray_count);

/* Accepts zeroed ones. */
void emission_free(struct emission *emission);

/* Whether the n-th light has more than one place. */
bool emission_has_size(const struct emission *emission, int n);

/* The light without a size that shines from one place, two numbers in [0, 1), as the whole n-th light does on
 * average. */
struct emitter emission_piece(const struct emission *emission, int n, vec2s place);

/* What a piece's slide lets pass of light in that unit direction. */
vec3s emission_slide(const struct emitter *piece, vec3s direction);

/* A place of the n-th light picked for this surface: of a rectangle by solid angle, of a sphere on the
 * side that it sees, of a sky by radiance. */
vec2s emission_place(const struct emission *emission, int n, vec2s sample, const struct hit *hit);

/* The same, even in area, but of surfaces and the sky, which are picked as above. */
vec2s emission_even_place(const struct emission *emission, int n, vec2s sample,
                          const struct hit *hit);

/* The n-th light alone, from that place. False where it cannot arrive: outside the cone, or from
 * behind. */
bool emission_reach(const struct emission *emission, int n, vec2s place, const struct hit *hit,
                    struct arrival *arrival);

/* Whether rays that leave the surface may come to some light by chance: of specular surfaces, to any that
 * has a size. */
bool emission_can_be_found(const struct emission *emission, const struct hit *hit);

/* What of the n-th light arrives from where a ray came to that left the surface in that direction: what it
 * met, or, where it meets nothing, out of the scene. False where it does not shine from there, or is not to be
 * found. */
bool emission_found(const struct emission *emission, const struct ray_scene *rays, int n,
                    const struct hit *hit, vec3s direction, const struct hit *met, bool meets,
                    struct arrival *arrival);

/* The weight of such a ray among ways to the same place whose densities are these, over
 * emission_place's; and of a pick of emission_place's. The power heuristic with exponent 2 [Veach 1997,
 * §9.2.4]. */
float emission_found_weight(const struct arrival *arrival, float other_density);
float emission_picked_weight(const struct arrival *arrival, float other_density);

/* The radiance that the surface reflects of what arrives. */
vec3s emission_reflected(const struct hit *hit, const struct arrival *arrival);

/* What it reflects of all lights. Traces the shadow rays: one for a light without a size, and for others
 * as many as there are samplers; and as many by its reflection where those may come to a light. */
struct reflected emission_direct(const struct emission *emission, const struct ray_scene *rays,
                                 const struct hit *hit, const struct sampler *samplers, int count);

/* Where a ray of the n-th light meets the scene first; false where it misses. The ray is picked by a
 * place and two numbers more in [0, 1): uniform in the solid angle of a spot or a point, in the
 * cosine of an area light, in the bounding sphere's cross section for a directional light. */
bool emission_first_hit(const struct emission *emission, int n, const struct ray_scene *rays,
                        vec2s place, vec2s sample, struct hit *hit);

#endif
