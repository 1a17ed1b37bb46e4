#include "renderer/light_plan.h"

#include "base/error.h"
#include "base/memory.h"
#include "renderer/caustics.h"
#include "renderer/light_search.h"
#include "renderer/views.h"
#include "techniques/many_lights.h"

#include <string.h>

/* Most lights that all have maps. Of more, lights with maps are directional ones and each that has
 * more than this part of all flux. Stand-ins have none: triangles of their surfaces are sampled. */
enum { MAPPED_LIGHTS_MAX = 16 };

/* Sampled lights light no medium and no glass, need rays, and have a direct method of their own. */
static bool may_sample(const struct renderer_desc *desc) {
    struct medium medium = renderer_medium(desc);
    return desc->technique->samples_lights && desc->direct == direct_for(&desc->emitters) &&
           !medium_exists(&medium) && !renderer_has_caustics(desc) &&
           many_lights_may_trace(desc->scene, desc->geometry);
}

static void divide_lights(struct light_plan *plan, const struct renderer_desc *desc) {
    struct emitters *mapped = &plan->mapped, *sampled = &plan->sampled;
    int count = desc->emitters.count, stand_ins = 0;
    double flux = 0;
    *mapped = emitters_copy(&desc->emitters);
    *sampled = (struct emitters){0};
    for (int i = 0; i < count; i++) {
        stand_ins += mapped->items[i].stands_in;
        if (mapped->items[i].type != EMITTER_DIRECTIONAL)
            flux += emitter_flux(&mapped->items[i], 1);
    }
    bool are_few = count - stand_ins <= MAPPED_LIGHTS_MAX;
    if ((are_few && stand_ins == 0) || !may_sample(desc))
        return;
    sampled->items = mem_alloc((size_t)count, sizeof *sampled->items);
    mapped->count = 0;
    for (int i = 0; i < count; i++) {
        const struct emitter *light = &desc->emitters.items[i];
        bool has_maps = !light->stands_in && (are_few || light->type == EMITTER_DIRECTIONAL ||
                                              MAPPED_LIGHTS_MAX * emitter_flux(light, 1) > flux);
        struct emitters *list = has_maps ? mapped : sampled;
        list->items[list->count++] = *light;
    }
}

void light_plan_free(struct light_plan *plan) {
    emitters_free(&plan->mapped);
    emitters_free(&plan->sampled);
}

/* Takes the fit of before where that is as wanted: it takes a while. */
static void plan_sky(struct light_plan *plan, const struct renderer *renderer,
                     const struct renderer_desc *desc) {
    const struct light_plan *before = plan == &renderer->plan ? NULL : &renderer->plan;
    const struct environment_settings *sky =
        settings_of(struct environment_settings, &desc->settings, &sky_part);
    const struct environment *environment = desc->emitters.sky;
    int room = LIGHTS_MAX - plan->mapped.count - (plan->sampled.count > 0);
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
static bool shine(const struct emitters *emitters) {
    bool some = false;
    for (int i = 0; i < emitters->count; i++)
        some |= emitter_flux(&emitters->items[i], 1) > 0;
    return some;
}

static bool fits(struct light_plan *plan) {
    const struct emitters *mapped = &plan->mapped;
    if (!light_layout_of(&plan->layout, mapped))
        return false;
    if (mapped->sky && mapped->count > LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN)
        return error_set("%d lights and a sky: at most %d shine beside one; --light picks some",
                         mapped->count, LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN);
    return mapped->count + (plan->sampled.count > 0) <= LIGHTS_MAX ||
           error_set("%d directional lights among others: at most %d shine at once", mapped->count,
                     LIGHTS_MAX - 1);
}

bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc) {
    struct light_samples samples;
    struct renderer_desc of_maps = *desc;
    divide_lights(plan, desc);
    of_maps.emitters = plan->mapped;
    if (!fits(plan)) {
        light_plan_free(plan);
        return false;
    }
    plan_sky(plan, renderer, desc);
    plan->light_samples = (struct light_samples_desc){
        LIGHT_SAMPLES, wide_light, desc->geometry->radius, shine(&plan->sampled), 0};
    light_samples_place(&samples, &plan->mapped,
                        &(struct light_samples_sky){&plan->sky, &plan->sky_samples},
                        &plan->light_samples, 0);
    plan->sample_layout = light_samples_layout(&samples);
    plan->sample_layout.unseen =
        light_search_is_unseen(renderer->light_search, &of_maps, &plan->sample_layout);
    return true;
}

bool renderer_init_sampled(struct renderer *renderer, const struct light_plan *plan) {
    const struct renderer_desc *desc = &renderer->desc;
    struct sampled_lights sampled;
    bool ok = sampled_lights_init(&sampled, &plan->sampled, desc->scene, desc->geometry);
    if (ok)
        renderer->sampled = sampled;
    return ok;
}

bool renderer_move_sampled(struct renderer *renderer) {
    const struct emitters *lights = &renderer->plan.sampled;
    struct sampled_lights before = renderer->sampled;
    bool has_triangles = false;
    for (int i = 0; i < lights->count; i++)
        has_triangles |= lights->items[i].stands_in;
    if (!has_triangles)
        return true;
    bool ok = renderer_init_sampled(renderer, &renderer->plan);
    if (ok)
        sampled_lights_free(&before);
    return ok;
}

bool renderer_begin_lights(struct light_change *change, struct renderer *renderer,
                           struct light_plan *plan) {
    const struct light_plan *old = &renderer->plan;
    *change = (struct light_change){.old = {.mapped = old->mapped, .sampled = old->sampled},
                                    .sampled = renderer->sampled};
    change->same = emitters_same(&plan->sampled, &old->sampled);
    if (change->same || renderer_init_sampled(renderer, plan))
        return true;
    light_plan_free(plan);
    return false;
}

void renderer_end_lights(struct light_change *change, struct renderer *renderer,
                         struct light_plan *plan, bool changed) {
    if (!change->same) {
        sampled_lights_free(changed ? &change->sampled : &renderer->sampled);
        if (!changed)
            renderer->sampled = change->sampled;
    }
    light_plan_free(changed ? &change->old : plan);
}
