/* Lights for the path tracer: arriving light at a surface, and rays that start from lights. */
#ifndef REFERENCE_SCENE_EMISSION_H
#define REFERENCE_SCENE_EMISSION_H

#include "base/deal.h"
#include "reference/sampler.h"
#include "reference/scene/medium_ball.h"
#include "reference/scene/ray_scene.h"
#include "reference/scene/sky.h"
#include "reference/scene/surfaces.h"
#include "scene/lights/emitter.h"
#include "scene/lights/light_tree.h"

enum source_kind { SOURCE_LIGHT, SOURCE_SURFACES, SOURCE_SKY };

/* Most lights that all count at each surface. More are sampled by a tree: so many for a sampler of
 * direct light or a vertex of a path, and at most at once. */
enum { LIGHTS_ALL_MAX = 64, LIGHT_CHOICES = 8, CHOICES_MAX = LIGHTS_ALL_MAX + 2 };

struct source {
    enum source_kind kind;
    struct emitter light; /* for SOURCE_LIGHT */
    float solid_angle;    /* cone of a spot or point, sr */
    float share;          /* fraction of all light rays that start from it */
};

struct emission {
    struct source *sources; /* lights come first */
    int count, light_count;
    bool has_tree; /* lights are sampled */
    struct light_tree tree;
    struct surfaces surfaces;
    struct sky sky;
    int surfaces_number, sky_number; /* indices of these sources; -1: none */
    bool has_sizes;                  /* some light has a size, so places on lights are sampled */
    bool has_found;                  /* rays of diffuse surfaces can hit some light */
    struct dealt *rays;              /* source of each light ray, in proportion to its flux */
    struct medium_ball medium;
    vec3s center; /* centre of the scene's bounding sphere */
    float radius; /* radius of this sphere, metres */
};

/* Unshadowed light of one place of a light at a surface. A place is two numbers in [0, 1).
 * Irradiance estimates the whole light, with the medium's transmittance. It and density are divided
 * by the density of emission_place relative to uniform area. */
struct arrival {
    vec3s at;         /* point towards the light; nothing blocks beyond it */
    vec3s direction;  /* unit, to the light */
    vec3s irradiance; /* by the shading normal, W/m2 */
    float density;    /* density of light rays on the surface, 1/m2 */
    /* Density of the place in emission_place, 1/sr; 0 if rays of the surface's reflection cannot
     * hit it. */
    float picked;
    float found; /* density of rays of the reflection at the place, over `picked` */
};

/* A source that counts at a surface. */
struct light_choice {
    int n;
    float weight; /* 1 over how often it is chosen on average; 1: always */
};

/* Makes the sources, with ray_count light rays (or none). `table` must outlive it and has the
 * emissive surfaces; NULL: their approximating lights are used. A black environment is no source.
 * The medium is empty; set it afterwards. */
void emission_init(struct emission *emission, const struct emitters *emitters,
                   const struct geometry *geometry, const struct hit_table *table, int ray_count);

/* Accepts a zeroed object. */
void emission_free(struct emission *emission);

/* Chooses the sources that count at a surface: all, or `most` samples of the lights by the tree,
 * stratified, and the others. Returns their number. random: in [0, 1). */
int emission_choose(const struct emission *emission, const struct hit *hit, float random, int most,
                    struct light_choice choices[CHOICES_MAX]);

/* Returns the weight of the n-th source among emission_choose's. */
float emission_choice_weight(const struct emission *emission, const struct hit *hit, int most,
                             int n);

/* Returns the next source after n (-1: the first) that a ray of the surface's reflection may meet;
 * `count` after the last. */
int emission_next_met(const struct emission *emission, const struct hit *hit, vec3s direction,
                      int n);

/* True if the n-th light has more than one place. */
bool emission_has_size(const struct emission *emission, int n);

/* Returns the point light at a place, two numbers in [0, 1). Its mean over places is the n-th
 * light. */
struct emitter emission_piece(const struct emission *emission, int n, vec2s place);

/* Returns the transmittance of the light's slide in a unit direction. */
vec3s emission_slide(const struct emitter *piece, vec3s direction);

/* Samples a place of the n-th light for this surface: a rectangle by solid angle, a sphere on its
 * visible side, an environment by radiance. */
vec2s emission_place(const struct emission *emission, int n, vec2s sample, const struct hit *hit);

/* Samples a place uniformly by area, except surfaces and the environment, which are sampled as by
 * emission_place. */
vec2s emission_even_place(const struct emission *emission, int n, vec2s sample,
                          const struct hit *hit);

/* Computes the light of the n-th light from `place`. False: the surface is outside the cone, or
 * either faces away. */
bool emission_reach(const struct emission *emission, int n, vec2s place, const struct hit *hit,
                    struct arrival *arrival);

/* Samples a place of the n-th light for this surface by three numbers in [0, 1) and computes its
 * light. Many surfaces are sampled by their tree, other lights as by emission_place. */
bool emission_reach_near(const struct emission *emission, int n, float which, vec2s sample,
                         const struct hit *hit, struct arrival *arrival);

/* Returns how often emission_choose and emission_reach_near sample the n-th light's place on
 * average, over how often emission_place does. */
float emission_times_chosen(const struct emission *emission, const struct hit *hit, int most, int n,
                            vec2s place);

/* True if rays of the surface's reflection can hit some light: for specular surfaces any light with
 * a size. */
bool emission_can_be_found(const struct emission *emission, const struct hit *hit);

/* Computes the light of the n-th light along a ray of the surface's reflection. met: the hit;
 * without `meets` the ray left the scene. False: the light does not shine from there, or cannot be
 * hit. */
bool emission_found(const struct emission *emission, const struct ray_scene *rays, int n,
                    const struct hit *hit, vec3s direction, const struct hit *met, bool meets,
                    struct arrival *arrival);

/* Return the weight of a ray that hits a light, and of a place of emission_place. It is the power
 * heuristic with exponent 2 [Veach 1997, §9.2.4]. other_density: of other ways, over
 * emission_place's. */
float emission_found_weight(const struct arrival *arrival, float other_density);
float emission_picked_weight(const struct arrival *arrival, float other_density);

/* Returns the radiance that the surface reflects of `arrival`. */
vec3s emission_reflected(const struct hit *hit, const struct arrival *arrival);

/* Returns the reflected direct light of all lights. Shadow rays: one to a point light; `count` to
 * others, and `count` of the reflection if they can hit a light. With a tree: LIGHT_CHOICES times
 * `count` to lights. */
struct reflected emission_direct(const struct emission *emission, const struct ray_scene *rays,
                                 const struct hit *hit, const struct sampler *samplers, int count);

/* Finds the first hit of a ray of the n-th light; false: none. A place and two numbers in [0, 1)
 * sample the ray. It is uniform in solid angle for a spot or point, and cosine-distributed for an
 * area light. For a directional light it is uniform in the bounding sphere's cross section. */
bool emission_first_hit(const struct emission *emission, int n, const struct ray_scene *rays,
                        vec2s place, vec2s sample, struct hit *hit);

#endif
