#include "reference/path.h"

#include "reference/reservoir.h"

/* Light vertices for each sampled ray: they cost a shadow ray only, and one packet has them all. */
enum { LIGHTS_PER_VERTEX = 4 };

/* --- by way of light vertices ----------------------------------------------------------------- */

/* Of a light vertex among the ways to it: the ray that x samples finds it, with that density, and
 * then the light is picked, so often on average, or found by a sampled ray, too. The power
 * heuristic with exponent 2 [Veach 1997, §9.2.4]: of the weights tried, the best on scenes where
 * light bounces off small patches. */
static float vertex_weight(float density, float p_ray, float chosen, float light_found) {
    float ray = p_ray / density; /* the densities' squares could overflow */
    float picked = ray * chosen, found = ray * light_found;
    return 1 / (1 + picked * picked + found * found);
}

/* The density, per area at a point y of that geometric normal, with which sampling the cosine at x
 * finds y; 0 where x and y do not face each other. The geometry term over pi, cos(x) cos(y) / (pi
 * d^2), is the same. */
static float cosine_density(const struct hit *x, vec3s y, vec3s normal) {
    vec3s path = glms_vec3_sub(y, x->position);
    float distance2 = glms_vec3_norm2(path);
    float cos_x = glms_vec3_dot(x->normal, path), cos_y = -glms_vec3_dot(normal, path);
    if (cos_x <= 0 || cos_y <= 0 || glms_vec3_dot(x->geometric_normal, path) <= 0)
        return 0;
    return (cos_x / distance2) * (cos_y / distance2) * GLM_1_PIf;
}

/* What a vertex sends to x, and with which density a ray that it samples finds the light, over that
 * with which it is picked. */
static vec3s sent_to(const struct light_vertices *lights, uint32_t i, const struct hit *x,
                     float *light_found) {
    const struct light_vertex *vertex = &lights->items[i];
    *light_found = vertex->found;
    if (vertex->diffuse)
        return vertex->radiance;
    const struct arrival *arrival = &lights->specular[i].arrival;
    struct hit y = lights->specular[i].hit;
    y.towards = vec3s_unit(glms_vec3_sub(x->position, y.position));
    brdf_turn(&y.brdf, y.normal, y.towards);
    if (arrival->picked > 0)
        *light_found =
            hit_density(&y, arrival->direction, glms_vec3_dot(y.normal, arrival->direction)) /
            arrival->picked;
    return emission_reflected(&y, arrival);
}

/* A light vertex that x sees. */
static struct reflected from_light_vertex(const struct light_vertices *lights, uint32_t i,
                                          const struct hit *x, float p_cosine) {
    float light_found, p_light = LIGHTS_PER_VERTEX * lights->items[i].density, p_ray = p_cosine;
    float chosen = lights->items[i].chosen;
    vec3s radiance = sent_to(lights, i, x, &light_found);
    if (x->brdf.diffuse) {
        float share = p_cosine / p_light * vertex_weight(p_light, p_ray, chosen, light_found);
        return (struct reflected){.diffuse = glms_vec3_scale(radiance, share)};
    }
    vec3s to_y = vec3s_unit(glms_vec3_sub(lights->items[i].position, x->position));
    float cosine = glms_vec3_dot(x->normal, to_y);
    if (cosine <= 0) /* p_cosine is rounded otherwise: in its plane */
        return (struct reflected){0};
    struct brdf_value value = brdf_eval(&x->brdf, x->normal, x->towards, to_y);
    p_ray *= hit_density(x, to_y, cosine) / (cosine * GLM_1_PIf);
    float share = p_cosine / p_light * vertex_weight(p_light, p_ray, chosen, light_found);
    vec3s light = glms_vec3_scale(radiance, share);
    return (struct reflected){
        glms_vec3_scale(light, value.diffuse),
        glms_vec3_scale(glms_vec3_mul(light, value.specular), GLM_PIf),
    };
}

/* The share of light that passes the medium. */
static vec3s passes_between(const struct path_scene *scene, vec3s x, vec3s y) {
    vec3s path = glms_vec3_sub(y, x);
    float length = glms_vec3_norm(path);
    if (!scene->emission->medium.exists)
        return glms_vec3_one();
    return medium_transmittance(&scene->emission->medium, x, glms_vec3_scale(path, 1 / length),
                                length);
}

/* By way of the first hits of light rays, a run of them at once. */
static struct reflected from_light_vertices(const struct path_scene *scene, const struct hit *x,
                                            const struct light_vertices *lights,
                                            struct sampler *sampler) {
    const struct ray_scene *rays = scene->rays;
    uint32_t first = sampler_next_run(sampler, LIGHTS_PER_VERTEX), run[LIGHTS_PER_VERTEX];
    float p_cosine[LIGHTS_PER_VERTEX];
    vec3s to[LIGHTS_PER_VERTEX];
    bool asked[LIGHTS_PER_VERTEX];
    vec3s visible[LIGHTS_PER_VERTEX];
    struct reflected sum = {0};
    for (uint32_t i = 0; i < LIGHTS_PER_VERTEX; i++) {
        run[i] = (first ^ i) % LIGHT_VERTEX_COUNT;
        const struct light_vertex *y = &lights->items[run[i]];
        p_cosine[i] = y->density > 0 ? cosine_density(x, y->position, y->normal) : 0;
        asked[i] = p_cosine[i] > 0;
        to[i] = ray_scene_above(rays, y->position, y->normal);
    }
    ray_scene_passes_4(rays, ray_scene_departure(rays, x), to, asked, visible);
    for (int i = 0; i < LIGHTS_PER_VERTEX; i++) {
        if (glms_vec3_max(visible[i]) <= 0)
            continue;
        struct reflected light = from_light_vertex(lights, run[i], x, p_cosine[i]);
        vec3s passes = passes_between(scene, x->position, lights->items[run[i]].position);
        light = reflected_scale(&light, glms_vec3_mul(passes, visible[i]));
        sum.diffuse = glms_vec3_add(sum.diffuse, light.diffuse);
        sum.specular = glms_vec3_add(sum.specular, light.specular);
    }
    return sum;
}

/* --- by way of sampled rays ------------------------------------------------------------------- */

/* A ray that a surface's reflection samples. */
struct step {
    vec3s direction;
    float density; /* 1/sr; of specular surfaces alone */
    struct reflected
        share;   /* of radiance that its end sends along it, what is reflected over the density */
    bool leaves; /* it does not run into its own surface */
    bool hits;   /* something, at `end` */
    struct hit end;
};

static void weigh(struct step *step, const struct hit *from) {
    const struct brdf *brdf = &from->brdf;
    step->share = (struct reflected){.diffuse = glms_vec3_one()};
    if (brdf->diffuse)
        return;
    float cosine = glms_vec3_dot(from->normal, step->direction);
    struct brdf_value value = brdf_eval(brdf, from->normal, from->towards, step->direction);
    step->density = brdf_density(brdf, from->normal, from->towards, step->direction);
    step->leaves = step->leaves && cosine > 0 && step->density > 0;
    if (!step->leaves)
        return;
    float share = cosine / step->density;
    step->share.diffuse = glms_vec3_fill(value.diffuse * share * GLM_1_PIf);
    step->share.specular = glms_vec3_scale(value.specular, share);
}

/* What the step's end sends passes the medium. */
static void pass_medium(const struct medium_ball *medium, const struct hit *from,
                        struct step *step) {
    float length = glms_vec3_distance(from->position, step->end.position);
    vec3s passes = medium_transmittance(medium, from->position, step->direction, length);
    step->share = reflected_scale(&step->share, passes);
}

static struct step take_step(const struct path_scene *scene, const struct hit *from, vec2s sample) {
    const struct ray_scene *rays = scene->rays;
    struct step step = {.direction = brdf_sample(&from->brdf, from->normal, from->towards, sample)};
    step.leaves = glms_vec3_dot(step.direction, from->geometric_normal) > 0;
    weigh(&step, from);
    step.hits = step.leaves &&
                ray_scene_hit(rays, ray_scene_departure(rays, from), step.direction, &step.end);
    if (step.hits)
        pass_medium(&scene->emission->medium, from, &step);
    if (step.leaves)
        step.share = reflected_scale(&step.share, step.end.share);
    return step;
}

/* The density, per area at its end, with which x samples the step. */
static float step_density(const struct hit *x, const struct step *step) {
    const struct hit *y = &step->end;
    if (x->brdf.diffuse)
        return cosine_density(x, y->position, y->geometric_normal);
    float cosine = -glms_vec3_dot(y->geometric_normal, step->direction);
    return step->density * cosine / glms_vec3_distance2(x->position, y->position);
}

/* By way of the y that the ray found. Of several lights one is asked for its shadow, picked
 * by what it would give without: three have the noise of a ray for each, with 27 it takes a
 * quarter of the rays. p_ray: step_density's. */
static vec3s from_ray(const struct ray_scene *rays, const struct emission *emission,
                      const struct hit *y, float p_ray, struct sampler *sampler) {
    bool picks_one = emission->count > 1 || emission->surfaces.tree.node_count > 0;
    vec2s picks = picks_one ? sampler_next(sampler) : (vec2s){{0, 0}};
    struct reservoir reservoir = {.pick = picks.x};
    vec2s sample = emission->has_sizes ? sampler_next(sampler) : (vec2s){{0, 0}};
    struct light_choice choices[CHOICES_MAX];
    int count = emission_choose(emission, y, picks.y, LIGHT_CHOICES, choices);
    for (int i = 0; i < count; i++) {
        int n = choices[i].n;
        struct arrival arrival;
        if (!emission_reach_near(emission, n, picks.y, sample, y, &arrival))
            continue;
        float weight = choices[i].weight, p_light = LIGHTS_PER_VERTEX * arrival.density / p_ray;
        arrival.found *= weight;
        weight *= emission_picked_weight(&arrival, weight * p_light);
        struct reflected given = {.diffuse =
                                      glms_vec3_scale(emission_reflected(y, &arrival), weight)};
        reservoir_offer(&reservoir, &given, arrival.at);
    }
    return reservoir_light(&reservoir, rays, y).diffuse;
}

/* By way of the y that the ray found, where the next step came to a light. */
static vec3s from_found_light(const struct ray_scene *rays, const struct emission *emission,
                              const struct hit *y, const struct step *next, float p_ray) {
    vec3s sum = glms_vec3_zero();
    for (int n = emission_next_met(emission, y, next->direction, -1);
         next->leaves && n < emission->count;
         n = emission_next_met(emission, y, next->direction, n)) {
        struct arrival arrival;
        if (!emission_found(emission, rays, n, y, next->direction, &next->end, next->hits,
                            &arrival))
            continue;
        float weight = emission_choice_weight(emission, y, LIGHT_CHOICES, n), found = arrival.found;
        float p_light = LIGHTS_PER_VERTEX * arrival.density / p_ray;
        arrival.found *= weight;
        float share = emission_found_weight(&arrival, weight * p_light) / found;
        sum = glms_vec3_add(sum, glms_vec3_scale(emission_reflected(y, &arrival), share));
    }
    return sum;
}

/* --- the path --------------------------------------------------------------------------------- */

/* Where a path is: the surface, and what its first surface reflects of radiance that leaves this
 * one. */
struct place {
    struct hit x;
    bool is_first, is_shining; /* the first surface is not diffuse */
    struct reflected share;
};

/* Adds light that x reflects. */
static void add_light(const struct place *place, const struct reflected *light,
                      struct reflected *sum) {
    const struct hit *x = &place->x;
    if (place->is_first) {
        *sum = *light;
        return;
    }
    vec3s diffuse = glms_vec3_mul(place->share.diffuse, x->brdf.albedo);
    sum->diffuse = glms_vec3_add(sum->diffuse, glms_vec3_mul(diffuse, light->diffuse));
    if (!x->brdf.diffuse)
        sum->diffuse =
            glms_vec3_add(sum->diffuse, glms_vec3_mul(place->share.diffuse, light->specular));
    if (place->is_shining)
        sum->specular = glms_vec3_add(sum->specular,
                                      glms_vec3_mul(place->share.specular, hit_radiance(x, light)));
}

/* Whether there is a next vertex: the path did not leave the scene or run into its own surface, nor
 * met a black back. */
static bool goes_on(const struct step *step) {
    return step->hits && !hit_is_black(&step->end);
}

static void go_on(struct place *place, const struct step *step) {
    if (place->is_first) {
        place->share = step->share;
    } else {
        vec3s all = hit_radiance(&place->x, &step->share);
        place->share.diffuse = glms_vec3_mul(place->share.diffuse, all);
        place->share.specular = glms_vec3_mul(place->share.specular, all);
    }
    place->is_first = false;
    place->x = step->end;
}

struct reflected path_indirect(const struct path_scene *scene, const struct light_vertices *lights,
                               const struct hit *first, struct sampler *sampler) {
    const struct ray_scene *rays = scene->rays;
    const struct emission *emission = scene->emission;
    struct reflected sum = {0};
    struct place place = {*first, .is_first = true, .is_shining = !first->brdf.diffuse};
    struct step step, next;
    bool has_next = false; /* taken already, in search of lights */
    for (int bounce = 0; bounce < scene->bounces; bounce++) {
        struct reflected light = from_light_vertices(scene, &place.x, lights, sampler);
        step = has_next ? next : take_step(scene, &place.x, sampler_next(sampler));
        bool ends = !goes_on(&step);
        vec3s along = glms_vec3_zero(); /* the step */
        if (!ends) {
            float p_ray = step_density(&place.x, &step);
            along = from_ray(rays, emission, &step.end, p_ray, sampler);
            has_next = emission_can_be_found(emission, &step.end);
            if (has_next) {
                next = take_step(scene, &step.end, sampler_next(sampler));
                along =
                    glms_vec3_add(along, from_found_light(rays, emission, &step.end, &next, p_ray));
            }
        }
        light.diffuse = glms_vec3_add(light.diffuse, glms_vec3_mul(step.share.diffuse, along));
        if (!place.x.brdf.diffuse)
            light.specular =
                glms_vec3_add(light.specular, glms_vec3_mul(step.share.specular, along));
        add_light(&place, &light, &sum);
        if (ends)
            break;
        go_on(&place, &step);
    }
    return sum;
}
