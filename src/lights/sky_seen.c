#include "lights/sky_seen.h"

#include "base/halton.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <math.h>
#include <stdlib.h>

enum {
    SEEN_SIDE = 16, /* places a side of the picture */
    AROUND = 2,     /* rays from each */
    PLACES = SEEN_SIDE * SEEN_SIDE * AROUND,
};

/* Of light that has longer ways, in mean weights. */
static const float least_weight = .1F;

/* A middle that comes to few places does not get all light of its group: elsewhere it would be too bright. */
static const float largest_scale = 1.4F;

struct place {
    vec3s position, normal;
};

struct places {
    const struct surface_rays *rays;
    struct place items[PLACES];
    int count;
};

/* What the picture shows the light of by one bounce. */
static void find_places(struct places *places, const struct camera *camera, float aspect) {
    for (int i = 0; i < SEEN_SIDE * SEEN_SIDE; i++) {
        const float point[2] = {((float)(i % SEEN_SIDE) + .5F) / SEEN_SIDE,
                                ((float)(i / SEEN_SIDE) + .5F) / SEEN_SIDE};
        struct surface_hit seen, met;
        if (!surface_rays_find_seen(places->rays, camera, point, aspect, &seen))
            continue;
        for (int k = 0; k < AROUND; k++) {
            uint32_t number = (uint32_t)(1 + AROUND * i + k);
            const float at[2] = {(float)radical_inverse(2, number),
                                 (float)radical_inverse(3, number)};
            vec3s direction = surface_ray_direction(seen.normal, at);
            if (surface_rays_find(places->rays, seen.position, direction, &met))
                places->items[places->count++] = (struct place){met.position, met.normal};
        }
    }
}

/* Of a directional light from there, the cosine that comes to a place. */
static float cosine_at(const struct places *places, const struct place *place, vec3s to) {
    float cosine = glms_vec3_dot(to, place->normal);
    return cosine > 0 && surface_rays_leave(places->rays, place->position, to) ? cosine : 0;
}

struct asking {
    const struct places *places;
    const struct environment_lights *lights;
    const struct environment *sky;
    float *cosines; /* of each light, the sum over places */
};

/* Each place asks in another direction of the light. */
static void ask_light(void *context, size_t index) {
    const struct asking *asking = context;
    const struct environment_light light =
        environment_light_turned(&asking->lights->items[index], asking->sky);
    float sum = 0;
    for (int i = 0; i < asking->places->count; i++) {
        uint32_t number = (uint32_t)i + 1;
        const float at[2] = {(float)radical_inverse(2, number), (float)radical_inverse(3, number)};
        vec3s to;
        environment_light_direction(&light, at, to.raw);
        sum += cosine_at(asking->places, &asking->places->items[i], vec3s_unit(to));
    }
    asking->cosines[index] = sum;
}

/* Returns cosines for a weight of 1, 0 where no light comes. */
static float find_weights(float weights[], const struct places *places,
                          const struct environment_lights *lights, const struct environment *sky) {
    float power = 0, useful = 0;
    parallel_for((size_t)lights->count, 0, ask_light,
                 &(struct asking){places, lights, sky, weights});
    for (int i = 0; i < lights->count; i++) {
        power += environment_light_power(&lights->items[i]);
        useful += weights[i] * environment_light_power(&lights->items[i]);
    }
    float unit = power > 0 ? useful / power : 0;
    for (int i = 0; i < lights->count; i++)
        weights[i] = unit > 0 ? least_weight + weights[i] / unit : 1;
    return unit;
}

static void scale_middles(struct sky_groups *groups, const struct environment_lights *lights,
                          const struct environment *sky, const struct places *places, float unit) {
    for (int g = 0; g < groups->count; g++) {
        struct emitter middle = sky_group_emitter(lights, groups, g, sky);
        vec3s to = {{-middle.direction[0], -middle.direction[1], -middle.direction[2]}};
        float sum = 0;
        for (int i = 0; i < places->count; i++)
            sum += cosine_at(places, &places->items[i], to);
        float weight = least_weight + sum / unit;
        groups->scales[g] = fminf(sky_group_weight(lights, groups, g) / weight, largest_scale);
    }
}

void sky_groups_by_seen(struct sky_groups *groups, const struct environment_lights *lights,
                        int count, const struct environment *sky, const struct surface_rays *rays,
                        const struct camera *camera, float aspect) {
    float weights[ENVIRONMENT_LIGHTS_MAX];
    struct places *places = mem_alloc(1, sizeof *places);
    places->rays = rays;
    find_places(places, camera, aspect);
    float unit = find_weights(weights, places, lights, sky);
    if (unit > 0)
        environment_lights_group_by_weights(groups, lights, weights, count);
    else
        environment_lights_group(groups, lights, count);
    if (unit > 0)
        scale_middles(groups, lights, sky, places, unit);
    free(places);
}
