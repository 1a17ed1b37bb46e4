#include "reference/scene/emission.h"

#include "reference/reservoir.h"
#include "reference/scene/rectangle.h"
#include "reference/vector.h"
#include "reference/warp.h"

#include "base/memory.h"

#include <float.h>
#include <math.h>

static float cross_section(const struct emission *emission) {
    return GLM_PIf * emission->radius * emission->radius;
}

static double flux_of(const struct emission *emission, int n) {
    const struct source *source = &emission->sources[n];
    switch (source->kind) {
    case SOURCE_LIGHT:
        break;
    case SOURCE_SURFACES:
        return GLM_PI * emission->surfaces.flux;
    case SOURCE_SKY:
        return emission->sky.power / 3 * (double)cross_section(emission);
    }
    return emitter_flux(&source->light, emission->radius);
}

static void deal_rays(struct emission *emission, int count) {
    double *fluxes = mem_alloc((size_t)emission->count, sizeof *fluxes);
    int *counts = mem_alloc((size_t)emission->count, sizeof *counts);
    emission->rays = mem_alloc((size_t)count, sizeof *emission->rays);
    for (int n = 0; n < emission->count; n++)
        fluxes[n] = flux_of(emission, n);
    deal(fluxes, emission->count, emission->rays, count, counts);
    for (int n = 0; n < emission->count && count > 0; n++)
        emission->sources[n].share = (float)counts[n] / (float)count;
    mem_free(fluxes, counts);
}

static void add_lights(struct emission *emission, const struct emitters *emitters) {
    for (int i = 0; i < emitters->count; i++) {
        const struct emitter *light = &emitters->items[i];
        if (emission->surfaces.table && light->stands_in)
            continue;
        emission->sources[emission->count++] =
            (struct source){.light = *light, .solid_angle = (float)emitter_solid_angle(light)};
        emission->has_sizes |= emitter_shape(light) != EMITTER_IS_POINT;
    }
    emission->light_count = emission->count;
    emission->has_tree = emission->count > LIGHTS_ALL_MAX;
}

static void build_tree(struct emission *emission) {
    size_t count = (size_t)emission->light_count;
    struct light_bounds *bounds = mem_alloc(count, sizeof *bounds);
    for (size_t i = 0; i < count; i++)
        bounds[i] = light_bounds_of(&emission->sources[i].light);
    light_tree_init(&emission->tree, bounds, emission->light_count);
    free(bounds);
}

static int add_found(struct emission *emission, enum source_kind kind) {
    emission->sources[emission->count].kind = kind;
    emission->has_sizes = emission->has_found = true;
    return emission->count++;
}

void emission_init(struct emission *emission, const struct emitters *emitters,
                   const struct geometry *geometry, const struct hit_table *table, int ray_count) {
    *emission = (struct emission){
        .sources = mem_alloc((size_t)emitters->count + 2, sizeof *emission->sources),
        .center = vector_of(geometry->center),
        .radius = geometry->radius,
        .surfaces_number = -1,
        .sky_number = -1,
    };
    if (table)
        surfaces_init(&emission->surfaces, table, emitters);
    add_lights(emission, emitters);
    if (emission->has_tree)
        build_tree(emission);
    if (emission->surfaces.count > 0)
        emission->surfaces_number = add_found(emission, SOURCE_SURFACES);
    if (emitters->sky && sky_init(&emission->sky, emitters->sky))
        emission->sky_number = add_found(emission, SOURCE_SKY);
    if (emission->count > 0)
        deal_rays(emission, ray_count);
}

void emission_free(struct emission *emission) {
    mem_free(emission->sources, emission->rays);
    surfaces_free(&emission->surfaces);
    light_tree_free(&emission->tree);
    sky_free(&emission->sky);
    *emission = (struct emission){0};
}

/* --- choices ---------------------------------------------------------------------------------- */

int emission_choose(const struct emission *emission, const struct hit *hit, float random, int most,
                    struct light_choice choices[CHOICES_MAX]) {
    struct light_sample samples[LIGHT_SAMPLES_MAX];
    int count = 0;
    if (emission->has_tree)
        count = light_tree_sample_some(&emission->tree, hit->position.raw, hit->normal.raw, random,
                                       most, samples);
    for (int i = 0; i < count; i++)
        choices[i] =
            (struct light_choice){samples[i].light, 1 / ((float)most * samples[i].probability)};
    for (int n = emission->has_tree ? emission->light_count : 0; n < emission->count; n++)
        choices[count++] = (struct light_choice){n, 1};
    return count;
}

float emission_choice_weight(const struct emission *emission, const struct hit *hit, int most,
                             int n) {
    if (!emission->has_tree || n >= emission->light_count)
        return 1;
    float probability =
        light_tree_probability(&emission->tree, hit->position.raw, hit->normal.raw, n);
    return probability > 0 ? 1 / ((float)most * probability) : FLT_MAX;
}

int emission_next_met(const struct emission *emission, const struct hit *hit, vec3s direction,
                      int n) {
    if (!emission->has_tree || n >= emission->light_count)
        return n + 1;
    bool meets = emission->has_sizes && !hit->brdf.diffuse;
    int met =
        meets ? light_tree_next_met(&emission->tree, n, hit->position.raw, direction.raw) : -1;
    return met < 0 ? emission->light_count : met;
}

bool emission_has_size(const struct emission *emission, int n) {
    const struct source *source = &emission->sources[n];
    return source->kind != SOURCE_LIGHT || emitter_shape(&source->light) != EMITTER_IS_POINT;
}

/* The light without a size that shines from one place as the whole source does on average; density:
 * with which the place is picked, where rays by the cosine might come there; else 0. Of a sky 1/sr,
 * of surfaces 1/m2. */
static struct emitter piece_of(const struct emission *emission, int n, vec2s place,
                               double *density) {
    const struct source *source = &emission->sources[n];
    *density = 0;
    switch (source->kind) {
    case SOURCE_LIGHT:
        break;
    case SOURCE_SURFACES:
        return surfaces_piece(&emission->surfaces, place.raw, density);
    case SOURCE_SKY:
        return sky_piece(&emission->sky, place.raw, density);
    }
    return emitter_piece(&source->light, place.raw);
}

struct emitter emission_piece(const struct emission *emission, int n, vec2s place) {
    double density;
    return piece_of(emission, n, place, &density);
}

/* Light rays start from an area light by the cosine, which is in the strength, else evenly. */
static float ray_density(const struct emitter *piece, const struct source *source, float strength,
                         float distance) {
    return piece->type == EMITTER_AREA ? strength * GLM_1_PIf
                                       : 1 / (source->solid_angle * distance * distance);
}

/* Over the density of emission_place's places, that of those that are even in area. solid_angle: of
 * a unit of area at the place. */
static float place_weight(const struct emitter *light, const struct hit *hit, float solid_angle) {
    struct seen_rectangle seen;
    enum emitter_shape shape = emitter_shape(light);
    if (shape == EMITTER_IS_RECTANGLE && rectangle_see(&seen, light, hit->position))
        return (float)(seen.solid_angle / (emitter_extent(light) * (double)solid_angle));
    return shape == EMITTER_IS_SPHERE ? .5f : 1;
}

/* The density with which emission_place picks a place of a light, 1/sr; 0 where nobody asks, as
 * none but a specular surface's rays look for such lights. weight, solid_angle: as place_weight has
 * them. */
static float picked_density(const struct emitter *light, const struct hit *hit, float weight,
                            float solid_angle) {
    if (hit->brdf.diffuse || emitter_shape(light) == EMITTER_IS_POINT)
        return 0;
    return 1 / (weight * (float)emitter_extent(light) * solid_angle);
}

vec3s emission_slide(const struct emitter *piece, vec3s direction) {
    vec3s rgb;
    emitter_slide(piece, direction.raw, rgb.raw);
    return rgb;
}

/* What of light arrives from so far away. */
static vec3s through_medium(const struct emission *emission, const struct hit *hit, vec3s direction,
                            float distance, vec3s light) {
    return glms_vec3_mul(
        light, medium_transmittance(&emission->medium, hit->position, direction, distance));
}

/* Light of a piece of the n-th light. picked: the density of its place, of a sky or surfaces. */
static bool reach(const struct emission *emission, int n, struct emitter light, double picked,
                  const struct hit *hit, struct arrival *arrival) {
    const struct source *source = &emission->sources[n];
    vec3s to_light = glms_vec3_negate(vector_of(light.direction));
    float distance = 2 * emission->radius; /* beyond the bounds from every point within */
    float strength = 1;                    /* irradiance across the beam, for an intensity of 1 */
    float density;                         /* of light rays across the beam, 1/m2 */
    float weight = 1;                      /* of the place */
    float solid_angle = 1;                 /* of a unit of its extent */
    float in_range = 1;
    if (light.type == EMITTER_DIRECTIONAL) {
        density = 1 / cross_section(emission);
    } else {
        vec3s path = glms_vec3_sub(vector_of(light.position), hit->position);
        float cos_axis;
        distance = glms_vec3_norm(path);
        if (distance == 0)
            return false;
        cos_axis = glms_vec3_dot(path, to_light) / distance;
        to_light = glms_vec3_scale(path, 1 / distance);
        strength = emitter_cone(&light, cos_axis) / (distance * distance);
        in_range = emitter_in_range(&light, distance);
        density = ray_density(&light, source, strength, distance);
        if (source->kind == SOURCE_SURFACES)
            picked *= (double)(distance * distance / cos_axis);
        else if (emission_has_size(emission, n) && cos_axis > 0) {
            solid_angle = cos_axis / (distance * distance);
            weight = place_weight(&source->light, hit, solid_angle);
        }
    }
    float cos_shading = glms_vec3_dot(hit->normal, to_light);
    float cos_geometric = glms_vec3_dot(hit->geometric_normal, to_light);
    if (strength * in_range <= 0 || cos_shading <= 0 || cos_geometric <= 0)
        return false;
    arrival->at = glms_vec3_add(hit->position, glms_vec3_scale(to_light, distance));
    arrival->irradiance =
        glms_vec3_scale(vector_of(light.intensity), weight * strength * in_range * cos_shading);
    if (light.slide)
        arrival->irradiance =
            glms_vec3_mul(arrival->irradiance, emission_slide(&light, glms_vec3_negate(to_light)));
    arrival->irradiance = through_medium(emission, hit, to_light, distance, arrival->irradiance);
    arrival->density = weight * density * cos_geometric * source->share;
    arrival->direction = to_light;
    arrival->picked = source->kind == SOURCE_LIGHT
                          ? picked_density(&source->light, hit, weight, solid_angle)
                          : (float)picked;
    arrival->found =
        arrival->picked > 0 ? hit_density(hit, to_light, cos_shading) / arrival->picked : 0;
    return true;
}

bool emission_reach(const struct emission *emission, int n, vec2s place, const struct hit *hit,
                    struct arrival *arrival) {
    double picked;
    struct emitter light = piece_of(emission, n, place, &picked);
    return reach(emission, n, light, picked, hit, arrival);
}

bool emission_reach_near(const struct emission *emission, int n, float which, vec2s sample,
                         const struct hit *hit, struct arrival *arrival) {
    struct emitter piece;
    double densities[2];
    if (n != emission->surfaces_number || emission->surfaces.tree.node_count == 0)
        return emission_reach(emission, n, emission_place(emission, n, sample, hit), hit, arrival);
    vec3s place = {{which, sample.x, sample.y}};
    if (!surfaces_piece_near(&emission->surfaces, hit, place, &piece, densities) ||
        !reach(emission, n, piece, densities[0], hit, arrival))
        return false;
    arrival->density *= (float)(densities[1] / densities[0]);
    return true;
}

float emission_times_chosen(const struct emission *emission, const struct hit *hit, int most, int n,
                            vec2s place) {
    return n == emission->surfaces_number ? surfaces_chosen(&emission->surfaces, hit, place.raw)
                                          : 1 / emission_choice_weight(emission, hit, most, n);
}

/* --- rays that come to a light ---------------------------------------------------------------- */

/* What comes from a direction: its radiance, the density with which the source picks it, 1/sr, and
 * that of light rays across it, 1/m2. */
struct found {
    vec3s radiance;
    float picked, rays;
};

static bool find_surface(const struct emission *emission, const struct hit *hit, vec3s direction,
                         const struct hit *end, struct found *found) {
    double densities[2];
    float cosine = -glms_vec3_dot(end->geometric_normal, direction);
    float distance2 = glms_vec3_distance2(end->position, hit->position);
    if (cosine <= 0 || glms_vec3_max(end->emission) <= 0 ||
        !surfaces_densities(&emission->surfaces, hit, end, densities) || !(densities[0] > 0))
        return false;
    *found = (struct found){end->emission, (float)densities[0] * distance2 / cosine,
                            cosine / distance2 * GLM_1_PIf *
                                emission->sources[emission->surfaces_number].share *
                                (float)(densities[1] / densities[0])};
    return true;
}

static bool find_sky(const struct emission *emission, vec3s direction, struct found *found) {
    if (emission->sky_number < 0)
        return false;
    environment_radiance(emission->sky.environment, direction.raw, found->radiance.raw);
    found->picked = (float)sky_density(&emission->sky, direction.raw);
    found->rays = emission->sources[emission->sky_number].share / cross_section(emission);
    return found->picked > 0;
}

bool emission_can_be_found(const struct emission *emission, const struct hit *hit) {
    return emission->has_found || (!hit->brdf.diffuse && emission->has_sizes);
}

/* A light that is no surface of the scene's list. What lies just before it hides nothing: it may be
 * the very surface that the light is. */
static bool find_light(const struct emission *emission, const struct ray_scene *rays, int n,
                       const struct hit *hit, vec3s direction, const struct hit *end,
                       struct arrival *arrival) {
    vec2s place;
    float distance;
    if (hit->brdf.diffuse || !emitter_meet(&emission->sources[n].light, hit->position.raw,
                                           direction.raw, place.raw, &distance))
        return false;
    float slack = 1e-4F * emission->radius;
    bool before = end && glms_vec3_distance(end->position, hit->position) < distance - slack;
    if ((before && !rays->has_panes) || !emission_reach(emission, n, place, hit, arrival) ||
        !(arrival->found > 0))
        return false;
    if (!rays->has_panes)
        return true;
    /* The ray may have met a pane by chance: the light has its own way. */
    vec3s passes =
        ray_scene_is_open(rays, ray_scene_departure(rays, hit), direction, distance - slack);
    arrival->irradiance = glms_vec3_mul(arrival->irradiance, passes);
    return glms_vec3_max(passes) > 0;
}

bool emission_found(const struct emission *emission, const struct ray_scene *rays, int n,
                    const struct hit *hit, vec3s direction, const struct hit *met, bool meets,
                    struct arrival *arrival) {
    const struct hit *end = meets ? met : NULL;
    float cosine = glms_vec3_dot(hit->normal, direction);
    float cos_geometric = glms_vec3_dot(hit->geometric_normal, direction);
    struct found found;
    if (cosine <= 0 || cos_geometric <= 0)
        return false;
    if (emission->sources[n].kind == SOURCE_LIGHT)
        return find_light(emission, rays, n, hit, direction, end, arrival);
    bool is_sky = emission->sources[n].kind == SOURCE_SKY;
    if (is_sky == (end != NULL) || !(end ? find_surface(emission, hit, direction, end, &found)
                                         : find_sky(emission, direction, &found)))
        return false;
    float distance = end ? glms_vec3_distance(end->position, hit->position) : INFINITY;
    vec3s irradiance = glms_vec3_scale(found.radiance, cosine / found.picked);
    irradiance = glms_vec3_mul(irradiance, met->share);
    *arrival = (struct arrival){
        .direction = direction,
        .irradiance = through_medium(emission, hit, direction, distance, irradiance),
        .density = found.rays * cos_geometric,
        .picked = found.picked,
        .found = hit_density(hit, direction, cosine) / found.picked,
    };
    return arrival->found > 0;
}

float emission_picked_weight(const struct arrival *arrival, float other_density) {
    return 1 / (1 + arrival->found * arrival->found + other_density * other_density);
}

/* Ratios may be large, and their squares infinite. */
float emission_found_weight(const struct arrival *arrival, float other_density) {
    float picked = 1 / arrival->found, other = other_density / arrival->found;
    return 1 / (1 + picked * picked + other * other);
}

/* Of a sphere, of a place and the one across, that which faces the surface. */
static vec2s facing_place(const struct emitter *light, vec2s place, const struct hit *hit) {
    struct emitter piece = emitter_piece(light, place.raw);
    vec3s to_hit = glms_vec3_sub(hit->position, vector_of(piece.position));
    if (glms_vec3_dot(to_hit, vector_of(piece.direction)) >= 0)
        return place;
    float turned = place.y + .5f;
    return (vec2s){{1 - place.x, turned < 1 ? turned : turned - 1}};
}

vec2s emission_even_place(const struct emission *emission, int n, vec2s sample,
                          const struct hit *hit) {
    const struct source *source = &emission->sources[n];
    return source->kind == SOURCE_LIGHT && emitter_shape(&source->light) == EMITTER_IS_SPHERE
               ? facing_place(&source->light, sample, hit)
               : sample;
}

vec2s emission_place(const struct emission *emission, int n, vec2s sample, const struct hit *hit) {
    const struct source *source = &emission->sources[n];
    struct seen_rectangle seen;
    if (source->kind == SOURCE_LIGHT && emitter_shape(&source->light) == EMITTER_IS_RECTANGLE &&
        rectangle_see(&seen, &source->light, hit->position))
        return rectangle_place(&seen, sample);
    return emission_even_place(emission, n, sample, hit);
}

/* --- what surfaces reflect -------------------------------------------------------------------- */

/* Times pi: of a Lambertian surface, irradiance. */
static struct reflected reflect(const struct hit *hit, const struct arrival *arrival, float share) {
    vec3s light = glms_vec3_scale(arrival->irradiance, share);
    if (hit->brdf.diffuse)
        return (struct reflected){.diffuse = light};
    struct brdf_value value = brdf_eval(&hit->brdf, hit->normal, hit->towards, arrival->direction);
    return (struct reflected){glms_vec3_scale(light, value.diffuse),
                              glms_vec3_scale(glms_vec3_mul(light, value.specular), GLM_PIf)};
}

static struct reflected add(struct reflected a, struct reflected b) {
    return (struct reflected){glms_vec3_add(a.diffuse, b.diffuse),
                              glms_vec3_add(a.specular, b.specular)};
}

static struct reflected scale(struct reflected light, float share) {
    return (struct reflected){glms_vec3_scale(light.diffuse, share),
                              glms_vec3_scale(light.specular, share)};
}

vec3s emission_reflected(const struct hit *hit, const struct arrival *arrival) {
    struct reflected light = reflect(hit, arrival, 1);
    return glms_vec3_scale(hit_radiance(hit, &light), GLM_1_PIf);
}

static struct reflected direct_from(const struct emission *emission, int n,
                                    const struct ray_scene *rays, const struct hit *hit,
                                    vec2s sample, float weight) {
    struct arrival arrival;
    vec2s place = emission_place(emission, n, sample, hit);
    if (!emission_reach(emission, n, place, hit, &arrival))
        return (struct reflected){0};
    vec3s passes = ray_scene_passes(rays, ray_scene_departure(rays, hit), arrival.at);
    if (glms_vec3_max(passes) <= 0)
        return (struct reflected){0};
    arrival.irradiance = glms_vec3_mul(arrival.irradiance, passes);
    arrival.found *= weight;
    return reflect(hit, &arrival, weight * emission_picked_weight(&arrival, 0));
}

/* Of emissive surfaces half may face away, and what is near counts most: so several places are
 * looked at for each shadow ray, which goes to one of them by what it would give [Talbot et al.
 * 2005]. A thousand triangles in a room have a third of the noise, for the time of twice as many
 * samples. Of a sky behind windows noise is who sees it, and no less by this. */
enum { CANDIDATES = 8 };

static struct reflected direct_resampled(const struct emission *emission, int n,
                                         const struct ray_scene *rays, const struct hit *hit,
                                         struct sampler *sampler) {
    vec2s picks = sampler_next(sampler);
    struct reservoir reservoir = {.pick = picks.x};
    for (int i = 0; i < CANDIDATES; i++) {
        struct arrival arrival;
        float which = ((float)i + picks.y) / CANDIDATES;
        if (!emission_reach_near(emission, n, which, sampler_next(sampler), hit, &arrival))
            continue;
        struct reflected given = reflect(hit, &arrival, emission_picked_weight(&arrival, 0));
        reservoir_offer(&reservoir, &given, arrival.at);
    }
    return scale(reservoir_light(&reservoir, rays, hit), 1.F / CANDIDATES);
}

/* Of lights by a ray that may come to one. */
static struct reflected direct_by_ray(const struct emission *emission, const struct ray_scene *rays,
                                      const struct hit *hit, vec2s sample) {
    vec3s direction = brdf_sample(&hit->brdf, hit->normal, hit->towards, sample);
    struct reflected sum = {0};
    struct hit end;
    if (glms_vec3_dot(direction, hit->geometric_normal) <= 0)
        return sum;
    bool ends = ray_scene_hit(rays, ray_scene_departure(rays, hit), direction, &end);
    for (int n = emission_next_met(emission, hit, direction, -1); n < emission->count;
         n = emission_next_met(emission, hit, direction, n)) {
        struct arrival arrival;
        if (!emission_found(emission, rays, n, hit, direction, &end, ends, &arrival))
            continue;
        float found = arrival.found;
        arrival.found *= emission_choice_weight(emission, hit, LIGHT_CHOICES, n);
        sum = add(sum, reflect(hit, &arrival, emission_found_weight(&arrival, 0) / found));
    }
    return sum;
}

/* Of lights of the tree, by one place of each choice. */
static struct reflected direct_of_choices(const struct emission *emission,
                                          const struct ray_scene *rays, const struct hit *hit,
                                          struct sampler *sampler) {
    struct light_choice choices[CHOICES_MAX];
    struct reflected sum = {0};
    int count = emission_choose(emission, hit, sampler_next(sampler).x, LIGHT_CHOICES, choices);
    for (int i = 0; i < count && choices[i].n < emission->light_count; i++) {
        vec2s sample = emission->has_sizes ? sampler_next(sampler) : (vec2s){{0, 0}};
        sum = add(sum, direct_from(emission, choices[i].n, rays, hit, sample, choices[i].weight));
    }
    return sum;
}

/* The mean over samplers; n = -1: of the lights of the tree; n = the count of sources: by rays that
 * may come to any. */
static struct reflected direct_of_many(const struct emission *emission, int n,
                                       const struct ray_scene *rays, const struct hit *hit,
                                       const struct sampler *samplers, int count) {
    struct reflected sum = {0}, light;
    for (int i = 0; i < count; i++) {
        struct sampler sampler = samplers[i];
        sampler.pair += (uint32_t)n;
        if (n < 0)
            light = direct_of_choices(emission, rays, hit, &sampler);
        else if (n == emission->count)
            light = direct_by_ray(emission, rays, hit, sampler_next(&sampler));
        else if (n == emission->surfaces_number)
            light = direct_resampled(emission, n, rays, hit, &sampler);
        else
            light = direct_from(emission, n, rays, hit, sampler_next(&sampler), 1);
        sum = add(sum, light);
    }
    return scale(sum, 1 / (float)count);
}

struct reflected emission_direct(const struct emission *emission, const struct ray_scene *rays,
                                 const struct hit *hit, const struct sampler *samplers, int count) {
    int ways = emission_can_be_found(emission, hit) ? emission->count + 1 : emission->count;
    struct reflected sum = {0}, light;
    if (emission->has_tree)
        sum = direct_of_many(emission, -1, rays, hit, samplers, count);
    for (int n = emission->has_tree ? emission->light_count : 0; n < ways; n++) {
        if (n < emission->count && !emission_has_size(emission, n))
            light = direct_from(emission, n, rays, hit, (vec2s){{0, 0}}, 1);
        else
            light = direct_of_many(emission, n, rays, hit, samplers, count);
        sum = add(sum, light);
    }
    return scale(sum, GLM_1_PIf);
}

bool emission_first_hit(const struct emission *emission, int n, const struct ray_scene *rays,
                        vec2s place, vec2s sample, struct hit *hit) {
    double picked;
    struct emitter light = piece_of(emission, n, place, &picked);
    vec3s axis = vector_of(light.direction), origin, direction;
    if (light.type == EMITTER_DIRECTIONAL) {
        vec3s offset = glms_vec3_sub(warp_to_disc(sample, axis), glms_vec3_scale(axis, 2));
        origin = glms_vec3_add(emission->center, glms_vec3_scale(offset, emission->radius));
        direction = axis;
    } else {
        direction =
            light.type == EMITTER_AREA
                ? warp_to_cosine(sample, axis)
                : warp_to_cone(sample, axis, light.type == EMITTER_SPOT ? light.cos_outer : -1);
        /* Shadow rays end this far before the light. */
        origin =
            glms_vec3_add(vector_of(light.position), glms_vec3_scale(direction, rays->clearance));
    }
    return ray_scene_hit(rays, origin, direction, hit);
}
