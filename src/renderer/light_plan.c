#include "renderer/light_plan.h"

#include "base/error.h"
#include "renderer/light_search.h"

/* Takes the fit of before where that is as wanted: it takes a while. */
static void plan_sky(struct light_plan *plan, const struct renderer *renderer,
                     const struct renderer_desc *desc) {
    const struct light_plan *before = plan == &renderer->plan ? NULL : &renderer->plan;
    const struct environment_settings *sky =
        settings_of(struct environment_settings, &desc->settings, &sky_part);
    const struct environment *environment = desc->emitters.sky;
    int room = LIGHTS_MAX - desc->emitters.count;
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

bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc) {
    struct light_samples samples;
    if (!light_layout_of(&plan->layout, &desc->emitters))
        return false;
    if (desc->emitters.sky && desc->emitters.count > LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN)
        return error_set("%d lights and a sky: at most %d shine beside one; --light picks some",
                         desc->emitters.count, LIGHTS_MAX - ENVIRONMENT_LIGHTS_MIN);
    plan_sky(plan, renderer, desc);
    plan->light_samples =
        (struct light_samples_desc){LIGHT_SAMPLES, wide_light, desc->geometry->radius};
    light_samples_place(&samples, &desc->emitters,
                        &(struct light_samples_sky){&plan->sky, &plan->sky_samples},
                        &plan->light_samples, 0);
    plan->sample_layout = light_samples_layout(&samples);
    plan->sample_layout.unseen =
        light_search_is_unseen(renderer->light_search, desc, &plan->sample_layout);
    return true;
}
