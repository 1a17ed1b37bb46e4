#include "renderer/light_search.h"

#include "base/memory.h"
#include "lights/sky_seen.h"
#include "scene/animation.h"
#include "scene/light_seen.h"
#include "techniques/many_lights.h"

#include <string.h>

/* By importance a quarter of the VPLs still follow flux alone: little is gained where that many
 * show. */
static const float least_seen = .4F;

struct looked_at {
    unsigned moved; /* the pose that last moved any of the geometry; and so of the rays */
    float aspect;
    struct camera camera;
};

/* The last answers, and what they depend on. */
struct lamps_answer {
    struct looked_at from;
    struct emitters emitters;
    bool unseen, known;
};

struct sky_answer {
    struct looked_at from;
    struct environment_lights lights;
    float turn;
    int count; /* at most so many groups; 0: there is no answer */
    bool by_seen;
    struct sky_groups groups;
};

struct light_search {
    const struct caster_pool *casters;
    struct surface_rays rays; /* zeroed before the first question */
    unsigned moved;           /* of the rays */
    struct lamps_answer lamps;
    struct sky_answer sky;
};

struct light_search *light_search_create(const struct caster_pool *casters) {
    struct light_search *search = mem_alloc(1, sizeof *search);
    search->casters = casters;
    return search;
}

static void forget(struct light_search *search) {
    if (search->rays.geometry)
        surface_rays_free(&search->rays);
    emitters_free(&search->lamps.emitters);
    *search = (struct light_search){.casters = search->casters};
}

void light_search_free(struct light_search *search) {
    if (search)
        forget(search);
    free(search);
}

static int importance_of(const struct renderer_desc *desc) {
    return settings_of(struct lights_settings, &desc->settings, &lights_part)->importance;
}

/* Light that stays while the camera moves is the same for all views. */
static bool may_search(const struct renderer_desc *desc) {
    const struct technique *technique = desc->technique;
    return technique->seeks_lights && desc->geometry->blocking_index_count > 0 &&
           scene_duration(desc->scene) <= 0 && many_lights_may_trace(desc->scene, desc->geometry);
}

/* Frames of what does not move have a pose each. */
static unsigned last_move(const struct geometry *geometry) {
    unsigned last = 0;
    for (int p = 0; p < geometry->part_count; p++)
        if (geometry->parts[p].moved > last)
            last = geometry->parts[p].moved;
    return last;
}

static struct looked_at looked_at(const struct renderer_desc *desc) {
    return (struct looked_at){last_move(desc->geometry), (float)desc->width / (float)desc->height,
                              desc->camera};
}

static bool same_look(const struct looked_at *a, const struct looked_at *b) {
    return a->moved == b->moved && a->aspect == b->aspect && cameras_same(&a->camera, &b->camera);
}

static const struct surface_rays *rays_for(struct light_search *search,
                                           const struct renderer_desc *desc) {
    unsigned moved = last_move(desc->geometry);
    if (!search->rays.geometry || search->moved != moved) {
        forget(search);
        surface_rays_init(&search->rays, desc->scene, desc->geometry,
                          caster_pool_built(search->casters, desc->geometry));
        search->moved = moved;
    }
    return &search->rays;
}

bool light_search_is_unseen(struct light_search *search, const struct renderer_desc *desc,
                            const struct light_layout *samples) {
    const struct looked_at from = looked_at(desc);
    struct lamps_answer *last = &search->lamps;
    if (importance_of(desc) != IMPORTANCE_AUTO || desc->emitters.sky || samples->lights == 0 ||
        samples->lights != samples->groups || !may_search(desc))
        return false;
    if (last->known && same_look(&last->from, &from) &&
        emitters_same(&last->emitters, &desc->emitters))
        return last->unseen;
    float seen = light_seen(rays_for(search, desc), &desc->emitters, &from.camera, from.aspect);
    emitters_free(&last->emitters);
    *last = (struct lamps_answer){from, emitters_copy(&desc->emitters), seen < least_seen, true};
    return last->unseen;
}

static bool same_sky(const struct environment_lights *a, const struct environment_lights *b) {
    return a->count == b->count &&
           memcmp(a->items, b->items, (size_t)a->count * sizeof *a->items) == 0;
}

void light_search_group_sky(struct light_search *search, struct sky_groups *groups,
                            const struct renderer_desc *desc,
                            const struct environment_lights *lights, int count) {
    const struct environment *sky = desc->emitters.sky;
    struct sky_answer *last = &search->sky;
    struct sky_answer now = {.from = looked_at(desc), .turn = sky ? sky->turn : 0, .count = count};
    now.by_seen = lights->count > 0 && importance_of(desc) != IMPORTANCE_OFF && may_search(desc);
    bool known = last->count == count && last->by_seen == now.by_seen &&
                 same_sky(&last->lights, lights) &&
                 (!now.by_seen || (last->turn == now.turn && same_look(&last->from, &now.from)));
    if (!known && now.by_seen)
        sky_groups_by_seen(&now.groups, lights, count, sky, rays_for(search, desc),
                           &now.from.camera, now.from.aspect);
    else if (!known)
        environment_lights_group(&now.groups, lights, count);
    if (!known) {
        now.lights = *lights;
        *last = now;
    }
    *groups = last->groups;
}
