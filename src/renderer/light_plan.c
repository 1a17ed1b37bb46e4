#include "renderer/light_plan.h"

#include "base/error.h"
#include "base/memory.h"
#include "renderer/caustics.h"
#include "renderer/light_search.h"
#include "renderer/views.h"
#include "techniques/many_lights.h"

#include <stdlib.h>
#include <string.h>

/* Most lights that all have maps. Of more, lights with maps are directional ones and each that has
 * more than this part of all flux. Triangles take the place of stand-ins. */
enum { MAPPED_LIGHTS_MAX = 16 };

/* Sampled lights light no medium and no glass, need rays, and have a direct method of their own. */
static bool may_sample(const struct renderer_desc *desc) {
    struct medium medium = renderer_medium(desc);
    return desc->technique->samples_lights && desc->direct == direct_for(&desc->emitters) &&
           !medium_exists(&medium) && !renderer_has_caustics(desc) &&
           many_lights_may_trace(desc->scene, desc->geometry);
}

/* Returns a copy of the lights, those with maps first. */
static struct emitters divide_lights(const struct renderer_desc *desc) {
    struct emitters all = emitters_copy(&desc->emitters);
    if (all.count <= MAPPED_LIGHTS_MAX || !may_sample(desc))
        return all;
    struct emitter *sampled = mem_alloc((size_t)all.count, sizeof *sampled);
    double flux = 0;
    int count = 0;
    for (int i = 0; i < all.count; i++)
        if (all.items[i].type != EMITTER_DIRECTIONAL)
            flux += emitter_flux(&all.items[i], 1);
    for (int i = 0; i < all.count; i++) {
        const struct emitter *light = &all.items[i];
        bool mapped = !light->stands_in && (light->type == EMITTER_DIRECTIONAL ||
                                            MAPPED_LIGHTS_MAX * emitter_flux(light, 1) > flux);
        if (mapped)
            all.items[count++] = *light;
        else
            sampled[all.sampled++] = *light;
    }
    memcpy(all.items + count, sampled, (size_t)all.sampled * sizeof *sampled);
    all.count = count;
    free(sampled);
    return all;
}

/* Takes the fit of before where that is as wanted: it takes a while. */
static void plan_sky(struct light_plan *plan, const struct renderer *renderer,
                     const struct renderer_desc *desc) {
    const struct light_plan *before = plan == &renderer->plan ? NULL : &renderer->plan;
    const struct environment_settings *sky =
        settings_of(struct environment_settings, &desc->settings, &sky_part);
    const struct environment *environment = desc->emitters.sky;
    int room = LIGHTS_MAX - desc->emitters.count - (desc->emitters.sampled > 0);
    struct sky_wanted *wanted = &plan->wanted;
    *wanted = (struct sky_wanted){environment, sky->fit, sky->lights};
    if (before && before->wanted.environment == environment && before->wanted.fit == wanted->fit &&
        before->wanted.lights == wanted->lights)
        plan->sky = before->sky;
    else {
        environment_lights_fit(&plan->sky, environment, (enum sky_fit)wanted->fit, wanted->lights);
        environment_lights_find_joins(&plan->sky);
    }
    light_search_group_sky(renderer->light_search, &plan->sky_samples, desc, &plan->sky,
                           sky->directions < room ? sky->directions : room);
}

/* Light samples of all wide lights together, from which their reflected light starts. */
enum { LIGHT_SAMPLES = 4 };

/* A wider light has several light samples; over the scene's radius, of a sun in radians. */
static const float wide_light = .3F;

/* Dark lights change nothing. */
static bool sampled_shine(const struct emitters *emitters) {
    bool shine = false;
    for (int i = 0; i < emitters->sampled; i++)
        shine |= emitter_flux(&emitters->items[emitters->count + i], 1) > 0;
    return shine;
}

bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc) {
    struct light_samples samples;
    struct renderer_desc divided = *desc;
    const struct emitters *lights = &divided.emitters;
    divided.emitters = divide_lights(desc);
    bool fits = light_layout_of(&plan->layout, lights);
    if (fits && lights->sky && lights->count > LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN)
        fits = error_set("%d lights and a sky: at most %d shine beside one; --light picks some",
                         lights->count, LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN);
    if (fits && lights->count + (lights->sampled > 0) > LIGHTS_MAX)
        fits = error_set("%d directional lights among others: at most %d shine at once",
                         lights->count, LIGHTS_MAX - 1);
    if (!fits) {
        emitters_free(&divided.emitters);
        return false;
    }
    plan->lights = *lights;
    plan_sky(plan, renderer, &divided);
    plan->light_samples = (struct light_samples_desc){
        LIGHT_SAMPLES, wide_light, desc->geometry->radius, sampled_shine(lights), 0};
    light_samples_place(&samples, lights,
                        &(struct light_samples_sky){&plan->sky, &plan->sky_samples},
                        &plan->light_samples, 0);
    plan->sample_layout = light_samples_layout(&samples);
    plan->sample_layout.unseen =
        light_search_is_unseen(renderer->light_search, &divided, &plan->sample_layout);
    return true;
}

bool renderer_init_sampled(struct renderer *renderer, const struct light_plan *plan) {
    const struct renderer_desc *desc = &renderer->desc;
    struct sampled_lights sampled;
    bool ok = sampled_lights_init(&sampled, &plan->lights, desc->scene, desc->geometry);
    if (ok)
        renderer->sampled = sampled;
    return ok;
}

bool renderer_move_sampled(struct renderer *renderer) {
    const struct emitters *lights = &renderer->plan.lights;
    struct sampled_lights before = renderer->sampled;
    bool has_triangles = false;
    for (int i = 0; i < lights->sampled; i++)
        has_triangles |= lights->items[lights->count + i].stands_in;
    if (!has_triangles)
        return true;
    bool ok = renderer_init_sampled(renderer, &renderer->plan);
    if (ok)
        sampled_lights_free(&before);
    return ok;
}

bool renderer_begin_lights(struct light_change *change, struct renderer *renderer,
                           struct light_plan *plan) {
    *change = (struct light_change){.lights = renderer->plan.lights, .sampled = renderer->sampled};
    change->same = emitters_same(&plan->lights, &change->lights);
    if (change->same || renderer_init_sampled(renderer, plan))
        return true;
    emitters_free(&plan->lights);
    return false;
}

void renderer_end_lights(struct light_change *change, struct renderer *renderer,
                         struct light_plan *plan, bool changed) {
    if (!change->same) {
        sampled_lights_free(changed ? &change->sampled : &renderer->sampled);
        if (!changed)
            renderer->sampled = change->sampled;
    }
    emitters_free(changed ? &change->lights : &plan->lights);
}
