#include "renderer/renderer.h"

#include "base/error.h"
#include "base/memory.h"
#include "direct/sampled.h"
#include "renderer/caustics.h"
#include "renderer/light_plan.h"
#include "renderer/light_search.h"
#include "renderer/sky_pieces.h"
#include "renderer/views.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "techniques/many_lights.h"
#include "techniques/volume.h"

#include "parts.h"

#include <string.h>

/* What is made together, and anew when what it depends on changes. */
enum part {
    PART_GBUFFER = 1,    /* size */
    PART_GEOMETRY = 2,   /* nothing but shaders */
    PART_DIRECT = 4,     /* method, its settings, layout of lights, lights of the environment */
    PART_TECHNIQUE = 8,  /* technique, its settings, layout of light samples */
    PART_ANTIALIAS = 16, /* size, samples */
    PART_COMPOSITE = 32, /* size, what the technique contributes */
    PART_MEAN = 64,      /* size, whether progressive */
    PART_REFINER = 128,  /* as technique; whether progressive */
    PART_AIRLIGHT = 256, /* layout of light samples; whether there is a medium, its steps */
    PART_CAUSTICS = 512, /* what caustics there are, their settings; whether there is a medium */
    PART_ALL = 1023,
    PART_SIZE = PART_GBUFFER | PART_ANTIALIAS | PART_COMPOSITE | PART_MEAN,
    PART_LIGHTS = PART_DIRECT | PART_TECHNIQUE | PART_AIRLIGHT, /* what render_lights draws with */
};

static bool has_emission(const struct renderer_desc *desc) {
    return desc->scene->surface_count > 0 || renderer_has_specular(desc);
}

static bool scatters(const struct renderer_desc *desc) {
    struct medium medium = renderer_medium(desc);
    return medium_exists(&medium);
}

/* Whether a medium or panes take from light on its way. */
static bool has_medium(const struct renderer *renderer) {
    return scatters(&renderer->desc) || geometry_has_panes(renderer_geometry(renderer));
}

static bool init_antialias(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return antialias_pass_init(
        &renderer->antialias,
        &(struct antialias_desc){.width = desc->width,
                                 .height = desc->height,
                                 .samples = renderer_picture(renderer).samples,
                                 .normal_maps = renderer_has_specular(desc) &&
                                                materials_have_normal_maps(desc->scene)});
}

/* With the light of sampled lights and of an environment, where there are some. */
static bool init_direct(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    renderer->direct = renderer->plan.sky.count > 0 ? &environment_direct : desc->direct;
    renderer->direct = renderer->plan.sampled.count > 0 ? &sampled_direct : renderer->direct;
    return renderer->direct->init(
        &renderer->direct_state,
        &(struct direct_desc){
            .settings = &desc->settings,
            .width = desc->width,
            .height = desc->height,
            .lights = &renderer->plan.layout,
            .specular = renderer_has_specular(desc),
            .medium = has_medium(renderer),
            .slides = desc->scene->slide_count > 0,
            .casters = renderer->casters,
            .may_trace = many_lights_may_trace(desc->scene, renderer_geometry(renderer)),
            .lamps = desc->direct,
            .sky = &renderer->plan.sky,
        });
}

static bool make_technique(const struct renderer *renderer, const struct technique *technique,
                           const struct settings *settings, void **state) {
    const struct renderer_desc *desc = &renderer->desc;
    const struct geometry *geometry = renderer_geometry(renderer);
    struct settings chosen = renderer_settings_chosen(settings, technique, desc->scene, geometry);
    return technique_check(technique, settings) &&
           technique->init(state, &(struct technique_desc){
                                      .settings = &chosen,
                                      .scene = desc->scene,
                                      .geometry = geometry,
                                      .casters = renderer->casters,
                                      .width = desc->width,
                                      .height = desc->height,
                                      .lights = &renderer->plan.sample_layout,
                                      .specular = renderer_has_specular(desc),
                                      .medium = has_medium(renderer),
                                  });
}

static bool init_technique(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    renderer->technique = desc->technique;
    return make_technique(renderer, desc->technique, &desc->settings, &renderer->technique_state);
}

static bool init_mean(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    struct refining *refining = &renderer->refining;
    unsigned kinds = renderer_caustic_kinds(desc, scatters(desc));
    return !desc->progressive ||
           (mean_pass_init(&refining->mean,
                           &(struct mean_desc){.width = desc->width,
                                               .height = desc->height,
                                               .specular = renderer_has_specular(desc),
                                               .medium = scatters(desc),
                                               .caustics = kinds & HAS_CAUSTICS,
                                               .volume_caustics = kinds & HAS_VOLUME_CAUSTICS}) &&
            antialias_pass_init(&refining->centers, &(struct antialias_desc){.width = desc->width,
                                                                             .height = desc->height,
                                                                             .samples = 1}));
}

static bool init_refiner(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    const struct refinement *refinement = desc->technique->refinement;
    struct refining *refining = &renderer->refining;
    if (!desc->progressive || !refinement)
        return true;
    struct settings settings = desc->settings;
    refining->technique = technique_find(refinement->technique);
    if (!refining->technique || !settings_assign(&settings, refinement->settings))
        return false;
    settings_copy_given(&settings, &desc->settings);
    return make_technique(renderer, refining->technique, &settings, &refining->state);
}

/* For the technique that is there, or else for what contributed before. */
static bool init_composite(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    unsigned contributes = renderer->composite.desc.contributes;
    if (renderer->technique) {
        struct contribution contribution = renderer_contribution(renderer);
        contributes = composite_kinds(&contribution);
    }
    contributes &= ~(unsigned)(HAS_CAUSTICS | HAS_VOLUME_CAUSTICS);
    contributes |= renderer_caustic_kinds(desc, scatters(desc));
    contributes |= has_medium(renderer) ? HAS_MEDIUM : 0U;
    return composite_pass_init(
        &renderer->composite,
        &(struct composite_desc){.width = desc->width,
                                 .height = desc->height,
                                 .contributes = contributes,
                                 .has_sky = desc->scene->environment,
                                 .has_emission = has_emission(desc),
                                 .has_specular = renderer_has_specular(desc)});
}

/* Diffusely. */
static bool panes_reflect(const struct renderer *renderer) {
    const struct geometry *geometry = renderer_geometry(renderer);
    bool some = false;
    for (int b = geometry->blocking_batch_count; b < geometry->batch_count; b++) {
        const struct material *material =
            &renderer->desc.scene->materials[geometry->batches[b].material];
        some |= material_transmits(material) < 1;
    }
    return some;
}

static bool init_airlight(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    const struct medium_settings *own =
        settings_of(struct medium_settings, &desc->settings, &medium_part);
    return !has_medium(renderer) ||
           airlight_init(&renderer->airlight,
                         &(struct airlight_part_desc){
                             .width = desc->width,
                             .height = desc->height,
                             .steps = scatters(desc) ? own->steps : 0,
                             .slides = desc->scene->slide_count > 0,
                             .sky = desc->scene->environment != NULL,
                             .irradiance = renderer->composite.desc.contributes & HAS_IRRADIANCE,
                             .reflects = panes_reflect(renderer),
                             .specular = renderer_has_specular(desc),
                             .panes = geometry_has_panes(renderer_geometry(renderer))
                                          ? renderer->casters
                                          : NULL,
                             .lights = renderer->plan.sample_layout});
}

static bool init_caustics(struct renderer *renderer) {
    return !renderer_has_caustics(&renderer->desc) ||
           IF_CAUSTICS(renderer_init_caustics(renderer, scatters(&renderer->desc)),
                       error_set("caustics: this build is without (caustics.surface=off)"));
}

static bool init_gbuffer(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return gbuffer_init(&renderer->gbuffer,
                        &(struct gbuffer_desc){.label = "g-buffer",
                                               .width = desc->width,
                                               .height = desc->height,
                                               .layers = 1,
                                               .has_emission = has_emission(desc),
                                               .has_specular = renderer_has_specular(desc)});
}

static bool init_geometry(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return geometry_pass_init(
        &renderer->geometry,
        &(struct geometry_desc){.has_emission = has_emission(desc),
                                .has_specular = renderer_has_specular(desc),
                                .has_mappings = materials_have_mappings(desc->scene)});
}

static bool resize_direct(struct renderer *renderer, int width, int height) {
    return renderer->direct->resize(renderer->direct_state, width, height);
}

static bool resize_airlight(struct renderer *renderer, int width, int height) {
    return airlight_resize(&renderer->airlight, width, height);
}

static bool resize_technique(struct renderer *renderer, int width, int height) {
    return renderer->technique->resize(renderer->technique_state, width, height);
}

static bool resize_refiner(struct renderer *renderer, int width, int height) {
    const struct refining *refining = &renderer->refining;
    return !refining->technique || refining->technique->resize(refining->state, width, height);
}

/* From the first of its members up to the last. */
#define MEMBERS(first, last)                                                                       \
    offsetof(struct renderer, first), offsetof(struct renderer, last) +                            \
                                          sizeof((struct renderer *)0)->last -                     \
                                          offsetof(struct renderer, first)

/* In the order in which they are made. */
static const struct part_row {
    enum part part;
    size_t offset, size; /* in struct renderer */
    bool (*init)(struct renderer *renderer);
    /* What stays takes another size as it is: its lights do not depend on it. NULL: is made anew */
    bool (*resize)(struct renderer *renderer, int width, int height);
} rows[] = {
    {PART_GBUFFER, MEMBERS(gbuffer, gbuffer), init_gbuffer, NULL},
    {PART_GEOMETRY, MEMBERS(geometry, geometry), init_geometry, NULL},
    {PART_DIRECT, MEMBERS(direct, direct_state), init_direct, resize_direct},
    {PART_ANTIALIAS, MEMBERS(antialias, antialias), init_antialias, NULL},
    {PART_TECHNIQUE, MEMBERS(technique, technique_state), init_technique, resize_technique},
    {PART_COMPOSITE, MEMBERS(composite, composite), init_composite, NULL},
    {PART_AIRLIGHT, MEMBERS(airlight, airlight), init_airlight, resize_airlight},
    {PART_CAUSTICS, MEMBERS(caustics, caustics), init_caustics,
     IF_CAUSTICS(renderer_resize_caustics, NULL)},
    {PART_MEAN, MEMBERS(refining.centers, refining.mean), init_mean, NULL},
    {PART_REFINER, MEMBERS(refining.technique, refining.state), init_refiner, resize_refiner},
};

enum { ROWS = sizeof rows / sizeof *rows };

static bool init_parts(struct renderer *renderer, unsigned parts) {
    bool ok = true;
    for (int i = 0; ok && i < ROWS; i++)
        ok = !(parts & rows[i].part) || rows[i].init(renderer);
    return ok;
}

static void set_defaults(struct renderer_desc *desc) {
    if (!desc->technique)
        desc->technique = technique_default;
    if (!desc->direct)
        desc->direct = direct_for(&desc->emitters);
    if (desc->settings.part_count == 0)
        renderer_settings_init(&desc->settings);
}

static bool check_camera(const struct camera *camera) {
    return (!camera_is_wide(camera) && !camera_is_distorted(camera)) ||
           error_set(
               "camera: frames are of plain pinholes; reference and Python have lens=, skew and "
               "distortion");
}

bool renderer_init(struct renderer *renderer, const struct renderer_desc *desc) {
    if (!check_camera(&desc->camera)) {
        *renderer = (struct renderer){0};
        return false;
    }
    *renderer = (struct renderer){.desc = *desc,
                                  .light_block = mem_alloc(1, sizeof *renderer->light_block),
                                  .sample_block = mem_alloc(1, sizeof *renderer->sample_block)};
    set_defaults(&renderer->desc);
    renderer->desc.emitters = emitters_copy(&desc->emitters);
    renderer_view_geometry(renderer);
    renderer->casters = caster_pool_create(desc->scene, renderer_geometry(renderer));
    renderer->light_search = light_search_create(renderer->casters);
    timers_init(&renderer->timers, desc->timed, gl.software);
    if (renderer_plan_lights(&renderer->plan, renderer, &renderer->desc) &&
        scene_gpu_init(&renderer->scene, desc->scene, renderer_geometry(renderer),
                       caster_pool_levels(renderer->casters)) &&
        (!desc->scene->environment || sky_pieces_init(&renderer->sky_pieces)) &&
        renderer_init_sampled(renderer, &renderer->plan) && init_parts(renderer, PART_ALL) &&
        buffer_init(&renderer->view_buffer, "view", sizeof renderer->camera_view, NULL) &&
        buffer_init(&renderer->light_buffer, "lights", sizeof *renderer->light_block, NULL) &&
        buffer_init(&renderer->sample_buffer, "samples", sizeof *renderer->sample_block, NULL)) {
        renderer_write_views(renderer);
        return true;
    }
    renderer_free(renderer);
    return false;
}

static void free_parts(struct renderer *renderer) {
    struct refining *refining = &renderer->refining;
    gbuffer_free(&renderer->gbuffer);
    geometry_pass_free(&renderer->geometry);
    antialias_pass_free(&renderer->antialias);
    composite_pass_free(&renderer->composite);
    airlight_free(&renderer->airlight);
    IF_CAUSTICS(renderer_free_caustics(renderer), (void)0);
    if (renderer->technique)
        renderer->technique->free(renderer->technique_state);
    if (renderer->direct)
        renderer->direct->free(renderer->direct_state);
    mean_pass_free(&refining->mean);
    antialias_pass_free(&refining->centers);
    if (refining->technique)
        refining->technique->free(refining->state);
}

void renderer_free(struct renderer *renderer) {
    free_parts(renderer);
    IF_VOLUME(renderer_forget_ambient_occlusion(renderer), (void)0);
    timers_free(&renderer->timers);
    scene_gpu_free(&renderer->scene);
    texture_free(&renderer->sky_pieces);
    sampled_lights_free(&renderer->sampled);
    caster_pool_free(renderer->casters);
    light_search_free(renderer->light_search);
    buffers_free(&renderer->view_buffer, &renderer->light_buffer, &renderer->sample_buffer);
    mem_free(renderer->light_block, renderer->sample_block, renderer->glass_view);
    emitters_free(&renderer->desc.emitters);
    light_plan_free(&renderer->plan);
    *renderer = (struct renderer){0};
}

/* --- changes --- */

static void swap_parts(struct renderer *a, struct renderer *b, unsigned parts) {
    struct renderer before = *a;
    for (const struct part_row *row = rows; row < rows + ROWS; row++)
        if (parts & row->part) {
            memcpy((char *)a + row->offset, (char *)b + row->offset, row->size);
            memcpy((char *)b + row->offset, (char *)&before + row->offset, row->size);
        }
}

/* Where one of several parts cannot take the size, those before it go back. */
static bool resize_parts(struct renderer *renderer, const struct renderer_desc *desc,
                         unsigned parts) {
    const struct renderer_desc *old = &renderer->desc;
    int i = 0;
    if (desc->width == old->width && desc->height == old->height)
        return true;
    while (i < ROWS && (!rows[i].resize || !(parts & rows[i].part) ||
                        rows[i].resize(renderer, desc->width, desc->height)))
        i++;
    if (i == ROWS)
        return true;
    while (--i >= 0)
        if (rows[i].resize && parts & rows[i].part)
            rows[i].resize(renderer, old->width, old->height);
    return false;
}

/* The new parts are made beside the old ones, which go only when all are there. */
static bool change(struct renderer *renderer, const struct renderer_desc *desc,
                   const struct light_plan *plan, unsigned parts) {
    struct renderer fresh = {.desc = *desc,
                             .casters = renderer->casters,
                             .plan = *plan,
                             .composite.desc = renderer->composite.desc};
    bool ok = init_parts(&fresh, parts) && resize_parts(renderer, desc, ~parts);
    if (ok) {
        if (parts ||
            IF_VOLUME(!settings_same(&desc->settings, &renderer->desc.settings, &volume_part), 0))
            IF_VOLUME(renderer_forget_ambient_occlusion(renderer), (void)0);
        swap_parts(renderer, &fresh, parts);
        renderer->desc = *desc;
        renderer->plan = *plan;
        renderer_write_views(renderer);
        renderer->lights_drawn &= !(parts & PART_LIGHTS);
        if (parts & PART_TECHNIQUE) { /* other passes, other timers */
            timers_free(&renderer->timers);
            timers_init(&renderer->timers, desc->timed, gl.software);
        }
    }
    free_parts(&fresh);
    return ok;
}

bool renderer_makes_technique(const struct renderer *renderer, const struct technique *technique,
                              const struct settings *settings) {
    const struct renderer_desc *desc = &renderer->desc;
    return technique != desc->technique ||
           !renderer_settings_same(settings, &desc->settings, technique->parts);
}

static unsigned parts_between(const struct renderer *renderer, const struct renderer_desc *desc,
                              const struct light_plan *plan) {
    const struct renderer_desc *old = &renderer->desc;
    const struct picture_settings *picture =
        settings_of(struct picture_settings, &desc->settings, &picture_part);
    unsigned parts = 0;
    if (renderer_makes_technique(renderer, desc->technique, &desc->settings))
        parts |= PART_TECHNIQUE | PART_COMPOSITE | PART_REFINER |
                 (geometry_has_panes(renderer_geometry(renderer)) ? PART_AIRLIGHT : 0U);
    if (desc->direct != old->direct ||
        !renderer_settings_same(&desc->settings, &old->settings, desc->direct->parts))
        parts |= PART_DIRECT;
    if (!light_layouts_same(&plan->layout, &renderer->plan.layout) ||
        plan->wanted.environment != renderer->plan.wanted.environment ||
        (plan->sampled.count > 0) != (renderer->plan.sampled.count > 0) ||
        (plan->sky.count > 0 && !settings_same(&desc->settings, &old->settings, &sky_part)))
        parts |= PART_DIRECT;
    if (!light_layouts_same(&plan->sample_layout, &renderer->plan.sample_layout))
        parts |= PART_TECHNIQUE | PART_COMPOSITE | PART_REFINER | PART_AIRLIGHT;
    if (scatters(desc) != scatters(old))
        parts |= PART_DIRECT | PART_TECHNIQUE | PART_REFINER | PART_COMPOSITE | PART_MEAN |
                 PART_AIRLIGHT;
    if (settings_number(&desc->settings, "medium.steps") !=
        settings_number(&old->settings, "medium.steps"))
        parts |= PART_AIRLIGHT;
    if (!settings_same(&desc->settings, &old->settings, &caustics_part) ||
        (scatters(desc) != scatters(old) &&
         (renderer_has_caustics(desc) || renderer_has_caustics(old))))
        parts |= PART_CAUSTICS | PART_COMPOSITE | PART_MEAN;
    if (renderer_has_caustics(desc) != renderer_has_caustics(old))
        parts |= PART_TECHNIQUE | PART_REFINER | PART_CAUSTICS | PART_COMPOSITE | PART_MEAN;
    if (picture->samples != renderer_picture(renderer).samples)
        parts |= PART_ANTIALIAS;
    if (desc->width != old->width || desc->height != old->height)
        parts |= PART_SIZE;
    if (desc->progressive != old->progressive)
        parts |= PART_MEAN | PART_REFINER;
    if (renderer_has_specular(desc) != renderer_has_specular(old))
        parts |= PART_ALL;
    return parts;
}

bool renderer_makes_programs(const struct renderer *renderer, const struct renderer_desc *wanted) {
    const unsigned with_programs = PART_ALL & ~(PART_SIZE | PART_COMPOSITE);
    struct renderer_desc desc = *wanted;
    struct light_plan plan;
    set_defaults(&desc);
    bool makes = false;
    if (renderer_plan_lights(&plan, renderer, &desc)) {
        makes = parts_between(renderer, &desc, &plan) & with_programs;
        light_plan_free(&plan);
    }
    return makes;
}

/* Puts a new one in its place. */
static bool start_anew(struct renderer *renderer, const struct renderer_desc *wanted) {
    struct renderer fresh;
    if (!renderer_init(&fresh, wanted))
        return false;
    struct emitters lights = fresh.desc.emitters;
    if (emitters_same(&lights, &renderer->desc.emitters)) { /* `wanted` may have the same array */
        fresh.desc.emitters = renderer->desc.emitters;
        renderer->desc.emitters = lights;
    }
    renderer_free(renderer);
    *renderer = fresh;
    renderer_write_views(renderer); /* the samples' emitters lie within the renderer */
    return true;
}

bool renderer_follow(struct renderer *renderer, const struct renderer_desc *wanted) {
    struct renderer_desc desc = *wanted;
    struct emitters old = renderer->desc.emitters;
    struct light_change lights;
    struct light_plan plan;
    set_defaults(&desc);
    /* Glass becomes an occluder or a pane, so the geometry changes. */
    if (renderer_has_caustics(&renderer->desc) != renderer_has_caustics(&desc))
        return start_anew(renderer, wanted);
    if (!check_camera(&desc.camera) || !renderer_plan_lights(&plan, renderer, &desc) ||
        !renderer_begin_lights(&lights, renderer, &plan))
        return false;
    bool same_lights = emitters_same(&desc.emitters, &old);
    desc.emitters = same_lights ? old : emitters_copy(&desc.emitters);
    bool same_samples = sky_groups_same(&plan.sky_samples, &renderer->plan.sky_samples);
    unsigned parts = parts_between(renderer, &desc, &plan);
    bool same_medium = settings_same(&desc.settings, &renderer->desc.settings, &medium_part);
    bool same_picture = parts == 0 && same_lights && same_samples && same_medium &&
                        cameras_same(&desc.camera, &renderer->desc.camera);
    bool ok = change(renderer, &desc, &plan, parts);
    renderer_end_lights(&lights, renderer, &plan, ok);
    if (!same_lights)
        emitters_free(ok ? &old : &desc.emitters);
    renderer->lights_drawn &=
        (same_lights && same_samples && same_medium) || !ok; /* VPLs hold what it passes */
    if (ok && !same_picture)
        renderer->refining.count = 0;
    return ok;
}

static bool update_state(const struct renderer *renderer, const struct technique *technique,
                         void *state) {
    return !technique || !technique->update ||
           technique->update(state, renderer_geometry(renderer));
}

static bool update_techniques(struct renderer *renderer) {
    const struct refining *refining = &renderer->refining;
    return renderer->lights_drawn ||
           (update_state(renderer, renderer->technique, renderer->technique_state) &&
            update_state(renderer, refining->technique, refining->state));
}

/* Those with a copy of the triangles. */
static bool remake_techniques(struct renderer *renderer) {
    const struct technique *refiner = renderer->refining.technique;
    unsigned parts = renderer->technique->update ? PART_TECHNIQUE | PART_COMPOSITE : 0U;
    parts |= refiner && refiner->update ? PART_REFINER : 0U;
    return change(renderer, &renderer->desc, &renderer->plan, parts);
}

bool renderer_update(struct renderer *renderer) {
    renderer_view_geometry(renderer);
    bool posed = renderer->scene.pose != renderer->desc.geometry->pose_count;
    bool changed = renderer->scene.pose < renderer->desc.geometry->changed;
    renderer->lights_drawn &= !posed;
    if (posed)
        renderer->refining.count = 0;
    if (posed && !renderer_move_sampled(renderer))
        return false;
    renderer_write_views(renderer);
    return scene_gpu_update(&renderer->scene, renderer_geometry(renderer)) &&
           caster_pool_update(renderer->casters) &&
           (changed ? remake_techniques(renderer) : update_techniques(renderer));
}

bool renderer_follows(const struct renderer *renderer, const struct geometry *geometry) {
    return !renderer_has_caustics(&renderer->desc) && !geometry_has_panes(geometry) &&
           geometry->balls_count == 0 && !caster_pool_is_large(geometry);
}

void renderer_relight(struct renderer *renderer) {
    renderer->lights_drawn = false;
    renderer->refining.count = 0;
}

bool renderer_reload_shaders(struct renderer *renderer) {
    renderer->refining.count = 0;
    return change(renderer, &renderer->desc, &renderer->plan, PART_ALL);
}
