#include "renderer/light_search.h"

#include "base/memory.h"
#include "scene/animation.h"
#include "scene/light_seen.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

/* By importance a quarter of the VPLs still follow flux alone: little is gained where that many show. */
static const float least_seen = .4F;

struct light_search {
    struct surface_rays rays; /* zeroed before the first question */
    struct light_question {
        unsigned pose; /* of the geometry; and so of the rays */
        float aspect;
        struct camera camera;
        struct emitters emitters;
    } last;
    bool unseen; /* the answer */
};

struct light_search *light_search_create(void) {
    return mem_alloc(1, sizeof(struct light_search));
}

static void forget(struct light_search *search) {
    if (search->rays.geometry)
        surface_rays_free(&search->rays);
    emitters_free(&search->last.emitters);
    *search = (struct light_search){0};
}

void light_search_free(struct light_search *search) {
    if (search)
        forget(search);
    free(search);
}

static bool is_asked(const struct renderer_desc *desc, const struct light_layout *samples) {
    const struct lights_settings *lights =
        settings_of(struct lights_settings, &desc->settings, &lights_part);
    return lights->importance == IMPORTANCE_AUTO && desc->technique->follows_camera &&
           desc->geometry->index_count > 0 && samples->lights > 0 &&
           samples->lights == samples->groups && !desc->emitters.sky &&
           scene_duration(desc->scene) <= 0 && many_lights_may_trace(desc->scene, desc->geometry);
}

static bool is_answered(const struct light_search *search, const struct light_question *question) {
    const struct light_question *last = &search->last;
    return search->rays.geometry && last->pose == question->pose &&
           last->aspect == question->aspect && cameras_same(&last->camera, &question->camera) &&
           emitters_same(&last->emitters, &question->emitters);
}

bool light_search_is_unseen(struct light_search *search, const struct renderer_desc *desc,
                            const struct light_layout *samples) {
    if (!is_asked(desc, samples))
        return false;
    struct light_question question = {desc->geometry->pose_count,
                                      (float)desc->width / (float)desc->height, desc->camera,
                                      desc->emitters};
    if (is_answered(search, &question))
        return search->unseen;
    if (!search->rays.geometry || search->last.pose != question.pose) {
        forget(search);
        surface_rays_init(&search->rays, desc->scene, desc->geometry);
    }
    search->unseen = light_seen(&search->rays, &question.emitters, &question.camera,
                                question.aspect) < least_seen;
    emitters_free(&search->last.emitters);
    question.emitters = emitters_copy(&question.emitters);
    search->last = question;
    return search->unseen;
}
