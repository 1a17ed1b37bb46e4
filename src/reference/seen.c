#include "reference/seen.h"

/* Lights of the tree for one surface. */
enum { SEEN_CHOICES = 32 };

/* What the light would give from four places, always the same: from its middle alone, one that is
 * half below the horizon might count for nothing. */
static vec3s rough_light(const struct emission *emission, int n, const struct hit *hit) {
    static const vec2s places[4] = {{{.25F, .25F}}, {{.75F, .25F}}, {{.25F, .75F}}, {{.75F, .75F}}};
    vec3s sum = glms_vec3_zero();
    struct arrival arrival;
    for (int i = 0; i < 4; i++)
        if (emission_reach(emission, n, emission_even_place(emission, n, places[i], hit), hit,
                           &arrival))
            sum = glms_vec3_add(sum, arrival.irradiance);
    return sum;
}

static vec3s unshadowed(const struct emission *emission, int n, const struct hit *hit,
                        vec2s sample) {
    struct arrival arrival;
    vec2s place = emission_place(emission, n, sample, hit);
    return emission_reach(emission, n, place, hit, &arrival) ? arrival.irradiance
                                                             : glms_vec3_zero();
}

/* Of places that could arrive, how many do. */
struct tally {
    float could, do_arrive;
};

static void look(const struct emission *emission, int n, const struct ray_scene *rays,
                 const struct hit *hit, vec2s sample, struct tally *tally) {
    struct arrival arrival;
    vec2s place = emission_even_place(emission, n, sample, hit);
    if (!emission_reach(emission, n, place, hit, &arrival))
        return;
    tally->could++;
    vec3s passes = ray_scene_passes(rays, ray_scene_departure(rays, hit), arrival.at);
    tally->do_arrive += glms_vec3_hadd(passes) / 3;
}

static void add_light(struct seen *seen, const struct emission *emission,
                      struct light_choice choice, const struct ray_scene *rays,
                      const struct hit *hit, const struct sampler *samplers, int count) {
    struct tally tally = {0};
    int n = choice.n;
    vec3s light = glms_vec3_zero();
    for (int i = 0; i < count; i++) {
        struct sampler sampler = samplers[i];
        sampler.pair += (uint32_t)n;
        vec2s sample = sampler_next(&sampler);
        light = glms_vec3_add(light, unshadowed(emission, n, hit, sample));
        look(emission, n, rays, hit, sample, &tally);
    }
    seen->unshadowed =
        glms_vec3_muladds(light, choice.weight * GLM_1_PIf / (float)count, seen->unshadowed);
    if (tally.could == 0)
        return;
    vec3s weight = glms_vec3_scale(rough_light(emission, n, hit), choice.weight);
    seen->all = glms_vec3_add(seen->all, weight);
    seen->visible = glms_vec3_muladds(weight, tally.do_arrive / tally.could, seen->visible);
}

struct seen seen_from(const struct emission *emission, const struct ray_scene *rays,
                      const struct hit *hit, const struct sampler *samplers, int count) {
    struct seen seen = {0};
    struct light_choice choices[CHOICES_MAX];
    struct sampler sampler = *samplers;
    sampler.pair += (uint32_t)emission->count;
    float random = emission->has_tree ? sampler_next(&sampler).x : 0;
    int chosen = emission_choose(emission, hit, random, SEEN_CHOICES, choices);
    for (int i = 0; i < chosen; i++)
        add_light(&seen, emission, choices[i], rays, hit, samplers,
                  emission_has_size(emission, choices[i].n) ? count : 1);
    return seen;
}
