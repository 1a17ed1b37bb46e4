#include "renderer/renderer.h"

#include "base/memory.h"
#include "shared/composite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const shown_layer_names[] = {
    [LAYER_BEAUTY] = "full", [LAYER_DIRECT] = "direct", [LAYER_INDIRECT] = "indirect", NULL};

/* Near the irradiance that the light could make across the scene. A narrow cone lights little, and
 * less than its intensity says. */
static float typical_irradiance(const struct emitter *light, float radius) {
    float brightest = fmaxf(light->intensity[0], fmaxf(light->intensity[1], light->intensity[2]));
    float share = light->type == EMITTER_SPOT
                      ? emitter_cone(light, 1) * fminf((float)emitter_solid_angle(light), 1)
                      : 1;
    return light->type == EMITTER_DIRECTIONAL ? brightest : brightest * share / (radius * radius);
}

/* A power of two near what all lights could make, inverted: exact to multiply by, and keeps half
 * floats in range whatever the units. */
static float irradiance_scale(const struct renderer_desc *desc) {
    float typical = 0;
    for (int i = 0; i < desc->emitters.count; i++)
        typical += typical_irradiance(&desc->emitters.items[i], desc->geometry->radius);
    return typical > 0 && isfinite(typical) ? exp2f(-roundf(log2f(typical))) : 1;
}

/* What is made together, and anew when what it depends on changes. */
enum part {
    PART_GBUFFER = 1,    /* size */
    PART_GEOMETRY = 2,   /* nothing but shaders */
    PART_DIRECT = 4,     /* method, its settings, layout of lights; takes size as it is */
    PART_TECHNIQUE = 8,  /* the same */
    PART_ANTIALIAS = 16, /* size, samples */
    PART_COMPOSITE = 32, /* size, what the technique contributes */
    PART_ALL = 63,
    PART_SIZE = PART_GBUFFER | PART_ANTIALIAS | PART_COMPOSITE,
    PART_LIGHTS = PART_DIRECT | PART_TECHNIQUE, /* what render_lights draws with */
};

static const struct picture_settings *picture_of(const struct renderer *renderer) {
    return settings_of(&renderer->desc.settings, &picture_part);
}

static bool init_antialias(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return antialias_pass_init(
        &renderer->antialias,
        &(struct antialias_desc){desc->width, desc->height, picture_of(renderer)->samples});
}

static bool init_direct(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    renderer->direct = desc->direct;
    return renderer->direct->init(&renderer->direct_state, &(struct direct_desc){
                                                               .settings = &desc->settings,
                                                               .width = desc->width,
                                                               .height = desc->height,
                                                               .lights = &renderer->layout,
                                                           });
}

static bool init_technique(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    renderer->technique = desc->technique;
    return technique_check(desc->technique, &desc->settings) &&
           renderer->technique->init(&renderer->technique_state, &(struct technique_desc){
                                                                     .settings = &desc->settings,
                                                                     .scene = desc->scene,
                                                                     .geometry = desc->geometry,
                                                                     .casters = renderer->casters,
                                                                     .width = desc->width,
                                                                     .height = desc->height,
                                                                     .lights = &renderer->layout,
                                                                 });
}

/* For the technique that is there, or else for another's contribution. */
static bool init_composite(struct renderer *renderer, unsigned contributes) {
    const struct renderer_desc *desc = &renderer->desc;
    if (renderer->technique) {
        struct contribution contribution = renderer_contribution(renderer);
        contributes = composite_kinds(&contribution);
    }
    return composite_pass_init(&renderer->composite,
                               &(struct composite_desc){desc->width, desc->height, contributes});
}

static bool init_parts(struct renderer *renderer, unsigned parts, unsigned contributes) {
    const struct renderer_desc *desc = &renderer->desc;
    return (!(parts & PART_GBUFFER) ||
            gbuffer_init(&renderer->gbuffer, "g-buffer", desc->width, desc->height, 1)) &&
           (!(parts & PART_GEOMETRY) || geometry_pass_init(&renderer->geometry)) &&
           (!(parts & PART_DIRECT) || init_direct(renderer)) &&
           (!(parts & PART_ANTIALIAS) || init_antialias(renderer)) &&
           (!(parts & PART_TECHNIQUE) || init_technique(renderer)) &&
           (!(parts & PART_COMPOSITE) || init_composite(renderer, contributes));
}

static void write_views(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    view_of_camera(&renderer->camera_view, &desc->camera, desc->geometry,
                   (float)desc->width / (float)desc->height);
    views_of_emitters(renderer->light_block, &desc->emitters, desc->geometry);
    buffer_write(&renderer->view_buffer, 0, sizeof renderer->camera_view, &renderer->camera_view);
    buffer_write(&renderer->light_buffer, 0, sizeof *renderer->light_block, renderer->light_block);
}

static void set_defaults(struct renderer_desc *desc) {
    if (!desc->technique)
        desc->technique = technique_default;
    if (!desc->direct)
        desc->direct = direct_default;
    if (desc->settings.part_count == 0)
        renderer_settings_init(&desc->settings);
}

bool renderer_init(struct renderer *renderer, const struct renderer_desc *desc) {
    *renderer = (struct renderer){.desc = *desc,
                                  .casters = caster_pool_create(desc->geometry),
                                  .light_block = mem_alloc(1, sizeof *renderer->light_block)};
    renderer->desc.emitters = emitters_copy(&desc->emitters);
    set_defaults(&renderer->desc);
    timers_init(&renderer->timers, desc->timed, gl.software);
    if (light_layout_of(&renderer->layout, &desc->emitters) &&
        scene_gpu_init(&renderer->scene, desc->scene, desc->geometry) &&
        init_parts(renderer, PART_ALL, 0) &&
        buffer_init(&renderer->view_buffer, "view", sizeof renderer->camera_view, NULL) &&
        buffer_init(&renderer->light_buffer, "lights", sizeof *renderer->light_block, NULL)) {
        write_views(renderer);
        return true;
    }
    renderer_free(renderer);
    return false;
}

static void free_parts(struct renderer *renderer) {
    gbuffer_free(&renderer->gbuffer);
    geometry_pass_free(&renderer->geometry);
    antialias_pass_free(&renderer->antialias);
    composite_pass_free(&renderer->composite);
    if (renderer->technique)
        renderer->technique->free(renderer->technique_state);
    if (renderer->direct)
        renderer->direct->free(renderer->direct_state);
}

void renderer_free(struct renderer *renderer) {
    free_parts(renderer);
    timers_free(&renderer->timers);
    scene_gpu_free(&renderer->scene);
    caster_pool_free(renderer->casters);
    buffer_free(&renderer->view_buffer);
    buffer_free(&renderer->light_buffer);
    free(renderer->light_block);
    emitters_free(&renderer->desc.emitters);
    *renderer = (struct renderer){0};
}

/* --- changes --- */

static void swap(void *a, void *b, size_t size) {
    unsigned char *x = a, *y = b;
    for (size_t i = 0; i < size; i++) {
        unsigned char byte = x[i];
        x[i] = y[i];
        y[i] = byte;
    }
}

#define SWAP(field) swap(&a->field, &b->field, sizeof a->field)

static void swap_parts(struct renderer *a, struct renderer *b, unsigned parts) {
    if (parts & PART_GBUFFER)
        SWAP(gbuffer);
    if (parts & PART_GEOMETRY)
        SWAP(geometry);
    if (parts & PART_DIRECT) {
        SWAP(direct);
        SWAP(direct_state);
    }
    if (parts & PART_ANTIALIAS)
        SWAP(antialias);
    if (parts & PART_COMPOSITE)
        SWAP(composite);
    if (parts & PART_TECHNIQUE) {
        SWAP(technique);
        SWAP(technique_state);
    }
}

/* What stays takes another size as it is: its lights do not depend on it. Where the second of two
 * cannot, the first goes back. */
static bool resize_kept(struct renderer *renderer, const struct renderer_desc *desc,
                        unsigned parts) {
    const struct renderer_desc *old = &renderer->desc;
    bool keeps_direct = !(parts & PART_DIRECT), keeps_technique = !(parts & PART_TECHNIQUE);
    if (desc->width == old->width && desc->height == old->height)
        return true;
    if (keeps_direct &&
        !renderer->direct->resize(renderer->direct_state, desc->width, desc->height))
        return false;
    if (!keeps_technique ||
        renderer->technique->resize(renderer->technique_state, desc->width, desc->height))
        return true;
    if (keeps_direct)
        renderer->direct->resize(renderer->direct_state, old->width, old->height);
    return false;
}

/* The new parts are made beside the old ones, which go only when all are there. */
static bool change(struct renderer *renderer, const struct renderer_desc *desc,
                   const struct light_layout *layout, unsigned parts) {
    struct renderer fresh = {.desc = *desc, .casters = renderer->casters, .layout = *layout};
    bool ok = init_parts(&fresh, parts, renderer->composite.desc.contributes) &&
              resize_kept(renderer, desc, parts);
    if (ok) {
        swap_parts(renderer, &fresh, parts);
        renderer->desc = *desc;
        renderer->layout = *layout;
        write_views(renderer);
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
                              const struct light_layout *layout) {
    const struct renderer_desc *old = &renderer->desc;
    const struct picture_settings *picture = settings_of(&desc->settings, &picture_part);
    unsigned parts = 0;
    if (renderer_makes_technique(renderer, desc->technique, &desc->settings))
        parts |= PART_TECHNIQUE | PART_COMPOSITE;
    if (desc->direct != old->direct ||
        !renderer_settings_same(&desc->settings, &old->settings, desc->direct->parts))
        parts |= PART_DIRECT;
    if (!light_layouts_same(layout, &renderer->layout))
        parts |= PART_DIRECT | PART_TECHNIQUE | PART_COMPOSITE;
    if (picture->samples != picture_of(renderer)->samples)
        parts |= PART_ANTIALIAS;
    if (desc->width != old->width || desc->height != old->height)
        parts |= PART_SIZE;
    return parts;
}

bool renderer_follow(struct renderer *renderer, const struct renderer_desc *wanted) {
    struct renderer_desc desc = *wanted;
    struct emitters old = renderer->desc.emitters;
    struct light_layout layout;
    if (!light_layout_of(&layout, &desc.emitters))
        return false;
    bool same_lights = emitters_same(&desc.emitters, &old);
    desc.emitters = same_lights ? old : emitters_copy(&desc.emitters);
    set_defaults(&desc);
    bool ok = change(renderer, &desc, &layout, parts_between(renderer, &desc, &layout));
    if (!same_lights)
        emitters_free(ok ? &old : &desc.emitters);
    renderer->lights_drawn &= same_lights || !ok;
    return ok;
}

static bool update_technique(struct renderer *renderer) {
    const struct technique *technique = renderer->technique;
    return renderer->lights_drawn || !technique->update ||
           technique->update(renderer->technique_state, renderer->desc.geometry);
}

bool renderer_update(struct renderer *renderer) {
    renderer->lights_drawn &= renderer->scene.pose == renderer->desc.geometry->pose_count;
    write_views(renderer);
    return scene_gpu_update(&renderer->scene, renderer->desc.geometry) &&
           caster_pool_update(renderer->casters) && update_technique(renderer);
}

bool renderer_reload_shaders(struct renderer *renderer) {
    return change(renderer, &renderer->desc, &renderer->layout, PART_ALL);
}

/* --- the frame --- */

struct frame renderer_frame(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    struct frame frame = {
        .timers = &renderer->timers,
        .view = &renderer->view_buffer,
        .lights = &renderer->light_buffer,
        .scene = &renderer->scene,
        .emitters = &desc->emitters,
        .light_block = renderer->light_block,
        .layout = renderer->layout,
        .radius = desc->geometry->radius,
        .irradiance_scale = irradiance_scale(desc),
    };
    memcpy(frame.bounds_min, desc->geometry->bounds_min, sizeof frame.bounds_min);
    memcpy(frame.bounds_max, desc->geometry->bounds_max, sizeof frame.bounds_max);
    return frame;
}

struct composite_inputs renderer_composite_inputs(const struct renderer *renderer) {
    return (struct composite_inputs){
        .gbuffer = &renderer->gbuffer,
        .direct = renderer->direct->light(renderer->direct_state),
        .contribution = renderer_contribution(renderer),
        .picks = &renderer->antialias.picks,
        .samples = renderer->antialias.samples,
        .exposure = renderer_exposure(renderer),
        .tone_map = (enum tone_map)picture_of(renderer)->tone_map,
        .layer = LAYER_BEAUTY,
    };
}

static void render_lights(struct renderer *renderer, const struct frame *frame) {
    if (renderer->lights_drawn && renderer->desc.keep_lights)
        return;
    if (renderer->direct->render_lights)
        renderer->direct->render_lights(renderer->direct_state, frame);
    if (renderer->technique->render_lights)
        renderer->technique->render_lights(renderer->technique_state, frame);
    renderer->lights_drawn = true;
}

void renderer_render(struct renderer *renderer) {
    struct frame frame = renderer_frame(renderer);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    timer_begin(&renderer->timers, "frame");
    render_lights(renderer, &frame);
    geometry_pass_render_camera(&renderer->geometry, &frame, &renderer->gbuffer);
    renderer->direct->render_view(renderer->direct_state, &frame, &renderer->gbuffer);
    renderer->technique->render_view(renderer->technique_state, &frame, &renderer->gbuffer);
    antialias_pass_render(&renderer->antialias, &frame, &renderer->gbuffer);
    composite_pass_render(&renderer->composite, &frame, &inputs);
    timer_end(&renderer->timers);
}

void renderer_compose(struct renderer *renderer, int layer) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    frame.timers = &untimed;
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    inputs.layer = layer;
    composite_pass_render(&renderer->composite, &frame, &inputs);
}

struct contribution renderer_contribution(const struct renderer *renderer) {
    return renderer->technique->contribution(renderer->technique_state);
}

float renderer_exposure(const struct renderer *renderer) {
    return picture_of(renderer)->exposure;
}

void renderer_outputs(const struct renderer *renderer, struct output_list *outputs) {
    const struct irradiance *irradiance = renderer_contribution(renderer).irradiance;
    const struct output rows[] = {
        {"normal", "G-buffer: world normals as colours", OUTPUT_NORMAL, &renderer->gbuffer.normal},
        {"albedo", "G-buffer: the surfaces' own colours", OUTPUT_ALBEDO, &renderer->gbuffer.albedo},
        {"depth", "G-buffer: near is bright", OUTPUT_DEPTH, &renderer->gbuffer.depth},
    };
    *outputs = (struct output_list){0};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
    if (renderer->technique->outputs)
        renderer->technique->outputs(renderer->technique_state, outputs);
    if (irradiance)
        output_add(outputs,
                   &(struct output){"irradiance", "after the blur, before the surfaces' colours",
                                    OUTPUT_IRRADIANCE, irradiance});
}
