#include "reference/path.h"

#include "reference/reservoir.h"
#include "reference/warp.h"

#include <math.h>

/* Light vertices for each cosine ray: they cost a shadow ray only, and one packet has them all. */
enum { LIGHTS_PER_VERTEX = 4 };

/* Of a light vertex among the ways to it: the cosine at x finds it, and then the light is picked, or found
 * by the cosine, too. The power heuristic with exponent 2 [Veach 1997, §9.2.4]: of the weights tried,
 * the best on scenes where light bounces off small patches. */
static float vertex_weight(const struct light_vertex *vertex, float density, float p_cosine) {
    float picked = p_cosine / density; /* the densities' squares could overflow */
    float found = picked * vertex->cosine;
    return 1 / (1 + picked * picked + found * found);
}

/* The density, per area at a point y of that geometric normal, with which sampling the cosine at x
 * finds y; 0 where x and y do not face each other. */
static float cosine_density(const struct hit *x, vec3s y, vec3s normal) {
    vec3s path = glms_vec3_sub(y, x->position);
    float distance2 = glms_vec3_norm2(path);
    float cos_x = glms_vec3_dot(x->normal, path), cos_y = -glms_vec3_dot(normal, path);
    if (cos_x <= 0 || cos_y <= 0 || glms_vec3_dot(x->geometric_normal, path) <= 0)
        return 0;
    return (cos_x / distance2) * (cos_y / distance2) * GLM_1_PIf;
}

/* By way of the first hits of light rays, a run of them at once. */
static vec3s from_light_vertices(const struct ray_scene *rays, const struct hit *x,
                                 const struct light_vertex *vertices, struct sampler *sampler) {
    uint32_t first = sampler_next_run(sampler, LIGHTS_PER_VERTEX);
    const struct light_vertex *run[LIGHTS_PER_VERTEX];
    float p_cosine[LIGHTS_PER_VERTEX];
    vec3s to[LIGHTS_PER_VERTEX], sum = glms_vec3_zero();
    bool visible[LIGHTS_PER_VERTEX];
    for (uint32_t i = 0; i < LIGHTS_PER_VERTEX; i++) {
        run[i] = &vertices[(first ^ i) % LIGHT_VERTEX_COUNT];
        p_cosine[i] = run[i]->density > 0 ? cosine_density(x, run[i]->position, run[i]->normal) : 0;
        visible[i] = p_cosine[i] > 0;
        to[i] = ray_scene_above(rays, run[i]->position, run[i]->normal);
    }
    ray_scene_visible_4(rays, ray_scene_departure(rays, x), to, visible);
    for (int i = 0; i < LIGHTS_PER_VERTEX; i++) {
        if (!visible[i])
            continue;
        /* The geometry term over pi, cos(x) cos(y) / (pi d^2), equals p_cosine. */
        float p_light = LIGHTS_PER_VERTEX * run[i]->density;
        float share = p_cosine[i] / p_light * vertex_weight(run[i], p_light, p_cosine[i]);
        sum = glms_vec3_muladds(run[i]->radiance, share, sum);
    }
    return sum;
}

/* By way of the y that the cosine at x found. Of several lights one is asked for its shadow, picked
 * by what it would give without: three have the noise of a ray for each, with 27 it takes a
 * quarter of the rays. */
static vec3s from_cosine_ray(const struct ray_scene *rays, const struct emission *emission,
                             const struct hit *x, const struct hit *y, struct sampler *sampler) {
    struct reservoir reservoir = {.pick = emission->count > 1 ? sampler_next(sampler).x : 0};
    vec2s sample = emission->has_sizes ? sampler_next(sampler) : (vec2s){{0, 0}};
    float p_cosine = cosine_density(x, y->position, y->geometric_normal);
    for (int n = 0; n < emission->count; n++) {
        struct arrival arrival;
        if (!emission_reach(emission, n, emission_place(emission, n, sample, y), y, &arrival))
            continue;
        float p_light = LIGHTS_PER_VERTEX * arrival.density / p_cosine;
        vec3s given = glms_vec3_scale(emission_reflected(y, &arrival),
                                      emission_picked_weight(&arrival, p_light));
        reservoir_offer(&reservoir, given, arrival.at);
    }
    return reservoir_light(&reservoir, rays, y);
}

/* A ray by the cosine. */
struct step {
    vec3s direction;
    bool leaves; /* it does not run into its own surface */
    bool hits;   /* something, at `end` */
    struct hit end;
};

static struct step take_step(const struct ray_scene *rays, const struct hit *from, vec2s sample) {
    struct step step = {.direction = warp_to_cosine(sample, from->normal)};
    step.leaves = glms_vec3_dot(step.direction, from->geometric_normal) > 0;
    step.hits = step.leaves &&
                ray_scene_hit(rays, ray_scene_departure(rays, from), step.direction, &step.end);
    return step;
}

/* By way of the y that the cosine at x found, where the next step came to a light. */
static vec3s from_found_light(const struct emission *emission, const struct hit *x,
                              const struct hit *y, const struct step *next) {
    struct arrival arrival;
    if (!next->leaves ||
        !emission_found(emission, y, next->direction, next->hits ? &next->end : NULL, &arrival))
        return glms_vec3_zero();
    float p_cosine = cosine_density(x, y->position, y->geometric_normal);
    float p_light = LIGHTS_PER_VERTEX * arrival.density / p_cosine;
    float share = emission_found_weight(&arrival, p_light) / arrival.cosine;
    return glms_vec3_scale(emission_reflected(y, &arrival), share);
}

/* Whether there is a next vertex: the path did not leave the scene or run into its own surface, nor
 * met a black back. */
static bool goes_on(const struct step *step) {
    return step->hits && glms_vec3_norm2(step->end.albedo) > 0;
}

vec3s path_indirect(const struct path_scene *scene, const struct light_vertex *lights,
                    const struct hit *first, struct sampler *sampler) {
    const struct ray_scene *rays = scene->rays;
    const struct emission *emission = scene->emission;
    vec3s sum = glms_vec3_zero(), throughput = glms_vec3_one();
    struct hit x = *first;
    struct step step, next;
    for (int bounce = 0; bounce < scene->bounces; bounce++) {
        vec3s light = from_light_vertices(rays, &x, lights, sampler);
        step = bounce && emission->has_found ? next : take_step(rays, &x, sampler_next(sampler));
        bool ends = !goes_on(&step);
        if (!ends)
            light = glms_vec3_add(light, from_cosine_ray(rays, emission, &x, &step.end, sampler));
        if (!ends && emission->has_found) {
            next = take_step(rays, &step.end, sampler_next(sampler));
            light = glms_vec3_add(light, from_found_light(emission, &x, &step.end, &next));
        }
        sum = glms_vec3_add(sum, glms_vec3_mul(throughput, light));
        if (ends)
            break;
        throughput = glms_vec3_mul(throughput, step.end.albedo);
        x = step.end;
    }
    return sum;
}
