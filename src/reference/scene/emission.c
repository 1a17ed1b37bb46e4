#include "reference/scene/emission.h"

#include "reference/vector.h"
#include "reference/warp.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

static void deal_rays(struct emission *emission, int count) {
    double *fluxes = mem_alloc((size_t)emission->count, sizeof *fluxes);
    int *counts = mem_alloc((size_t)emission->count, sizeof *counts);
    emission->rays = mem_alloc((size_t)count, sizeof *emission->rays);
    for (int n = 0; n < emission->count; n++)
        fluxes[n] = emitter_flux(&emission->sources[n].light, emission->radius);
    deal(fluxes, emission->count, emission->rays, count, counts);
    for (int n = 0; n < emission->count && count > 0; n++)
        emission->sources[n].share = (float)counts[n] / (float)count;
    free(fluxes);
    free(counts);
}

void emission_init(struct emission *emission, const struct emitters *emitters,
                   const struct geometry *geometry, int ray_count) {
    *emission = (struct emission){
        .sources = mem_alloc((size_t)emitters->count, sizeof *emission->sources),
        .count = emitters->count,
        .center = vector_of(geometry->center),
        .radius = geometry->radius,
    };
    for (int n = 0; n < emitters->count; n++)
        emission->sources[n] = (struct source){
            .light = emitters->items[n],
            .solid_angle = (float)emitter_solid_angle(&emitters->items[n]),
        };
    deal_rays(emission, ray_count);
}

void emission_free(struct emission *emission) {
    free(emission->sources);
    free(emission->rays);
    *emission = (struct emission){0};
}

static float cross_section(const struct emission *emission) {
    return GLM_PIf * emission->radius * emission->radius;
}

bool emission_reach(const struct emission *emission, int n, const struct hit *hit,
                    struct arrival *arrival) {
    const struct source *source = &emission->sources[n];
    const struct emitter *light = &source->light;
    vec3s to_light = glms_vec3_negate(vector_of(light->direction));
    float distance = 2 * emission->radius; /* beyond the bounds from every point within */
    float strength = 1;                    /* irradiance across the beam, for an intensity of 1 */
    float density;                         /* of light rays across the beam, 1/m2 */
    if (light->type == EMITTER_DIRECTIONAL) {
        density = 1 / cross_section(emission);
    } else {
        vec3s path = glms_vec3_sub(vector_of(light->position), hit->position);
        float cos_axis;
        distance = glms_vec3_norm(path);
        if (distance == 0)
            return false;
        cos_axis = glms_vec3_dot(path, to_light) / distance;
        to_light = glms_vec3_scale(path, 1 / distance);
        strength = emitter_cone(light, cos_axis) / (distance * distance);
        density = 1 / (source->solid_angle * distance * distance);
    }
    float cos_shading = glms_vec3_dot(hit->normal, to_light);
    float cos_geometric = glms_vec3_dot(hit->geometric_normal, to_light);
    if (strength <= 0 || cos_shading <= 0 || cos_geometric <= 0)
        return false;
    arrival->at = glms_vec3_add(hit->position, glms_vec3_scale(to_light, distance));
    arrival->irradiance = glms_vec3_scale(vector_of(light->intensity), strength * cos_shading);
    arrival->density = density * cos_geometric * source->share;
    return true;
}

vec3s emission_reflected(const struct hit *hit, const struct arrival *arrival) {
    return glms_vec3_scale(glms_vec3_mul(hit->albedo, arrival->irradiance), GLM_1_PIf);
}

vec3s emission_direct(const struct emission *emission, const struct ray_scene *rays,
                      const struct hit *hit) {
    struct arrival arrival;
    vec3s from = ray_scene_departure(rays, hit), sum = glms_vec3_zero();
    for (int n = 0; n < emission->count; n++)
        if (emission_reach(emission, n, hit, &arrival) && ray_scene_visible(rays, from, arrival.at))
            sum = glms_vec3_add(sum, arrival.irradiance);
    return glms_vec3_scale(sum, GLM_1_PIf);
}

bool emission_first_hit(const struct emission *emission, int n, const struct ray_scene *rays,
                        vec2s sample, struct hit *hit) {
    const struct emitter *light = &emission->sources[n].light;
    vec3s axis = vector_of(light->direction), origin, direction;
    if (light->type == EMITTER_DIRECTIONAL) {
        vec3s offset = glms_vec3_sub(warp_to_disc(sample, axis), glms_vec3_scale(axis, 2));
        origin = glms_vec3_add(emission->center, glms_vec3_scale(offset, emission->radius));
        direction = axis;
    } else {
        direction = warp_to_cone(sample, axis, light->type == EMITTER_SPOT ? light->cos_outer : -1);
        /* Shadow rays end this far before the light. */
        origin =
            glms_vec3_add(vector_of(light->position), glms_vec3_scale(direction, rays->clearance));
    }
    return ray_scene_hit(rays, origin, direction, hit);
}
