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

struct emitters renderer_divide_lights(const struct renderer_desc *desc) {
    struct emitters all = emitters_copy(&desc->emitters);
    all.count += all.sampled;
    all.sampled = 0;
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

bool renderer_init_sampled(struct renderer *renderer, const struct renderer_desc *desc) {
    struct sampled_lights sampled;
    bool ok = sampled_lights_init(&sampled, &desc->emitters, desc->scene, desc->geometry);
    if (ok)
        renderer->sampled = sampled;
    return ok;
}

bool renderer_move_sampled(struct renderer *renderer) {
    const struct emitters *emitters = &renderer->desc.emitters;
    struct sampled_lights before = renderer->sampled;
    bool has_triangles = false;
    for (int i = 0; i < emitters->sampled; i++)
        has_triangles |= emitters->items[emitters->count + i].stands_in;
    if (!has_triangles)
        return true;
    bool ok = renderer_init_sampled(renderer, &renderer->desc);
    if (ok)
        sampled_lights_free(&before);
    return ok;
}

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
    if (!light_layout_of(&plan->layout, &desc->emitters))
        return false;
    if (desc->emitters.sky && desc->emitters.count > LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN)
        return error_set("%d lights and a sky: at most %d shine beside one; --light picks some",
                         desc->emitters.count, LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN);
    plan_sky(plan, renderer, desc);
    plan->light_samples = (struct light_samples_desc){
        LIGHT_SAMPLES, wide_light, desc->geometry->radius, sampled_shine(&desc->emitters), 0};
    light_samples_place(&samples, &desc->emitters,
                        &(struct light_samples_sky){&plan->sky, &plan->sky_samples},
                        &plan->light_samples, 0);
    plan->sample_layout = light_samples_layout(&samples);
    plan->sample_layout.unseen =
        light_search_is_unseen(renderer->light_search, desc, &plan->sample_layout);
    return true;
}

bool renderer_begin_lights(struct light_change *change, struct renderer *renderer,
                           struct renderer_desc *desc) {
    *change = (struct light_change){.old = renderer->desc.emitters, .sampled = renderer->sampled};
    desc->emitters = renderer_divide_lights(desc);
    change->same = emitters_same(&desc->emitters, &change->old);
    if (change->same || !renderer_init_sampled(renderer, desc)) {
        emitters_free(&desc->emitters);
        desc->emitters = change->old;
        return change->same;
    }
    change->fresh = desc->emitters;
    return true;
}

void renderer_end_lights(struct light_change *change, struct renderer *renderer, bool changed) {
    if (change->same)
        return;
    sampled_lights_free(changed ? &change->sampled : &renderer->sampled);
    if (!changed)
        renderer->sampled = change->sampled;
    emitters_free(changed ? &change->old : &change->fresh);
}
