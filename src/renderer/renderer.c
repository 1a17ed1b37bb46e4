#include "renderer/renderer.h"

#include "shared/params.h"

#include <cglm/util.h>

#include <math.h>
#include <string.h>

const char *const shown_layer_names[] = {
    [LAYER_BEAUTY] = "full", [LAYER_DIRECT] = "direct", [LAYER_INDIRECT] = "indirect", NULL};

/* A power of two near the irradiance that the light could make across the scene, inverted: exact to
 * multiply by, and keeps half floats in range whatever the units. */
static float irradiance_scale(const struct renderer_desc *desc) {
    const struct emitter *light = &desc->light;
    float brightest = fmaxf(light->intensity[0], fmaxf(light->intensity[1], light->intensity[2]));
    float radius = desc->geometry->radius;
    /* A narrow cone lights little, and less than its intensity says. */
    float share = light->type == EMITTER_SPOT
                      ? emitter_cone(light, 1) * fminf((float)emitter_solid_angle(light), 1)
                      : 1;
    float typical =
        light->type == EMITTER_DIRECTIONAL ? brightest : brightest * share / (radius * radius);
    return typical > 0 && isfinite(typical) ? exp2f(-roundf(log2f(typical))) : 1;
}

/* What is made together, and anew when what it depends on changes. */
enum part {
    PART_CASTER = 1,     /* caster_edge, caster_error of the technique */
    PART_SIZE = 2,       /* G-buffer, composite: size */
    PART_GEOMETRY = 4,   /* nothing but shaders */
    PART_SHADOW = 8,     /* shadow_size, number of light views */
    PART_DIRECT = 16,    /* size, shadow_bias */
    PART_TECHNIQUE = 32, /* technique, all settings, number of light views; the size it takes as it
                            is */
    PART_ANTIALIAS = 64, /* size, samples */
    PART_ALL = 127,
    PART_SHADERS = PART_ALL & ~PART_CASTER,
    PART_LIGHTS = PART_CASTER | PART_SHADOW | PART_TECHNIQUE, /* what render_lights draws with */
};

static struct caster_desc caster_desc(int technique, const struct settings *settings) {
    return (struct caster_desc){
        .max_edge = settings->caster_edge,
        .error = techniques[technique]->exact_casters ? 0 : settings->caster_error,
    };
}

static bool init_caster(struct renderer *renderer) {
    struct caster_desc desc = caster_desc(renderer->desc.technique, &renderer->desc.settings);
    return caster_pool_acquire(renderer->casters, &renderer->caster, &desc);
}

static bool init_size(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return gbuffer_init(&renderer->gbuffer, "g-buffer", desc->width, desc->height, 1) &&
           composite_pass_init(&renderer->composite,
                               &(struct composite_desc){desc->width, desc->height});
}

static bool init_shadow(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return shadow_map_pass_init(
        &renderer->shadow_map,
        &(struct shadow_map_desc){desc->settings.shadow_size, emitter_view_count(&desc->light)});
}

static bool init_direct(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return direct_pass_init(&renderer->direct, &(struct direct_desc){desc->width, desc->height,
                                                                     desc->settings.shadow_bias});
}

static bool init_antialias(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return antialias_pass_init(
        &renderer->antialias,
        &(struct antialias_desc){desc->width, desc->height, desc->settings.samples});
}

static bool init_technique(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    renderer->technique = techniques[desc->technique];
    return renderer->technique->init(&renderer->technique_state,
                                     &(struct technique_desc){
                                         .settings = &desc->settings,
                                         .width = desc->width,
                                         .height = desc->height,
                                         .light_views = emitter_view_count(&desc->light),
                                     });
}

static bool init_parts(struct renderer *renderer, unsigned parts) {
    return (!(parts & PART_CASTER) || init_caster(renderer)) &&
           (!(parts & PART_SIZE) || init_size(renderer)) &&
           (!(parts & PART_GEOMETRY) || geometry_pass_init(&renderer->geometry)) &&
           (!(parts & PART_SHADOW) || init_shadow(renderer)) &&
           (!(parts & PART_DIRECT) || init_direct(renderer)) &&
           (!(parts & PART_ANTIALIAS) || init_antialias(renderer)) &&
           (!(parts & PART_TECHNIQUE) || init_technique(renderer));
}

static void write_views(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    view_of_camera(&renderer->camera_view, &desc->camera, desc->geometry,
                   (float)desc->width / (float)desc->height);
    view_of_emitter(&renderer->light_block, &desc->light, desc->geometry);
    buffer_write(&renderer->view_buffer, 0, sizeof renderer->camera_view, &renderer->camera_view);
    buffer_write(&renderer->light_buffer, 0, sizeof renderer->light_block, &renderer->light_block);
}

bool renderer_init(struct renderer *renderer, const struct renderer_desc *desc) {
    *renderer = (struct renderer){.desc = *desc, .casters = caster_pool_create(desc->geometry)};
    timers_init(&renderer->timers, desc->timed, desc->software);
    if (scene_gpu_init(&renderer->scene, desc->scene, desc->geometry) &&
        init_parts(renderer, PART_ALL) &&
        buffer_init(&renderer->view_buffer, "view", sizeof renderer->camera_view, NULL) &&
        buffer_init(&renderer->light_buffer, "light", sizeof renderer->light_block, NULL)) {
        write_views(renderer);
        return true;
    }
    renderer_free(renderer);
    return false;
}

static void free_parts(struct renderer *renderer) {
    caster_pool_release(renderer->casters, &renderer->caster);
    gbuffer_free(&renderer->gbuffer);
    geometry_pass_free(&renderer->geometry);
    shadow_map_pass_free(&renderer->shadow_map);
    direct_pass_free(&renderer->direct);
    antialias_pass_free(&renderer->antialias);
    composite_pass_free(&renderer->composite);
    if (renderer->technique)
        renderer->technique->free(renderer->technique_state);
}

void renderer_free(struct renderer *renderer) {
    free_parts(renderer);
    timers_free(&renderer->timers);
    scene_gpu_free(&renderer->scene);
    caster_pool_free(renderer->casters);
    buffer_free(&renderer->view_buffer);
    buffer_free(&renderer->light_buffer);
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
    if (parts & PART_CASTER)
        SWAP(caster);
    if (parts & PART_SIZE) {
        SWAP(gbuffer);
        SWAP(composite);
    }
    if (parts & PART_GEOMETRY)
        SWAP(geometry);
    if (parts & PART_SHADOW)
        SWAP(shadow_map);
    if (parts & PART_DIRECT)
        SWAP(direct);
    if (parts & PART_ANTIALIAS)
        SWAP(antialias);
    if (parts & PART_TECHNIQUE) {
        SWAP(technique);
        SWAP(technique_state);
    }
}

/* Where the technique stays, it takes another size as it is: its lights do not depend on it. */
static bool resize_technique(struct renderer *renderer, const struct renderer_desc *desc) {
    bool same = desc->width == renderer->desc.width && desc->height == renderer->desc.height;
    return same ||
           renderer->technique->resize(renderer->technique_state, desc->width, desc->height);
}

/* The new parts are made beside the old ones, which go only when all are there. */
static bool change(struct renderer *renderer, const struct renderer_desc *desc, unsigned parts) {
    struct renderer fresh = {.desc = *desc, .casters = renderer->casters};
    bool ok =
        init_parts(&fresh, parts) && (parts & PART_TECHNIQUE || resize_technique(renderer, desc));
    if (ok) {
        swap_parts(renderer, &fresh, parts);
        renderer->desc = *desc;
        write_views(renderer);
        renderer->lights_drawn &= !(parts & PART_LIGHTS);
        if (parts & PART_TECHNIQUE) { /* other passes, other timers */
            timers_free(&renderer->timers);
            timers_init(&renderer->timers, desc->timed, desc->software);
        }
    }
    free_parts(&fresh);
    return ok;
}

static unsigned parts_of_setting(const struct option *option) {
    if (!option->reinit)
        return 0;
    if (option->offset == offsetof(struct settings, caster_edge) ||
        option->offset == offsetof(struct settings, caster_error))
        return 0; /* changes_caster */
    if (option->offset == offsetof(struct settings, shadow_size))
        return PART_SHADOW;
    if (option->offset == offsetof(struct settings, shadow_bias))
        return PART_DIRECT;
    if (option->offset == offsetof(struct settings, samples))
        return PART_ANTIALIAS;
    return PART_TECHNIQUE;
}

bool renderer_makes_casters(const struct renderer *renderer, int technique,
                            const struct settings *settings) {
    struct caster_desc desc = caster_desc(technique, settings);
    return !caster_pool_has(renderer->casters, &desc);
}

/* Whether other casters are needed, made or not. */
static bool changes_caster(const struct renderer_desc *desc, int technique,
                           const struct settings *settings) {
    struct caster_desc old = caster_desc(desc->technique, &desc->settings);
    struct caster_desc new = caster_desc(technique, settings);
    return memcmp(&old, &new, sizeof old) != 0;
}

bool renderer_configure(struct renderer *renderer, int technique, const struct settings *settings) {
    struct renderer_desc desc = renderer->desc;
    unsigned parts = (technique == desc.technique ? 0 : PART_TECHNIQUE) |
                     (changes_caster(&desc, technique, settings) ? PART_CASTER : 0);
    for (const struct option *option = settings_table; option->name; option++)
        if (!option_equal(option, settings, &desc.settings))
            parts |= parts_of_setting(option);
    desc.technique = technique;
    desc.settings = *settings;
    return settings_check(settings) && change(renderer, &desc, parts);
}

bool renderer_resize(struct renderer *renderer, int width, int height) {
    struct renderer_desc desc = renderer->desc;
    if (width == desc.width && height == desc.height)
        return true;
    desc.width = width;
    desc.height = height;
    return change(renderer, &desc, PART_SIZE | PART_DIRECT | PART_ANTIALIAS);
}

bool renderer_set_light(struct renderer *renderer, const struct emitter *light) {
    struct renderer_desc desc = renderer->desc;
    bool same_views = emitter_view_count(light) == emitter_view_count(&desc.light);
    renderer->lights_drawn &= memcmp(light, &desc.light, sizeof *light) == 0;
    desc.light = *light;
    return change(renderer, &desc, same_views ? 0 : PART_SHADOW | PART_TECHNIQUE);
}

void renderer_set_camera(struct renderer *renderer, const struct camera *camera) {
    renderer->desc.camera = *camera;
    write_views(renderer);
}

bool renderer_update(struct renderer *renderer, const struct emitter *light,
                     const struct camera *camera) {
    renderer->desc.camera = *camera;
    renderer->lights_drawn &= renderer->scene.pose == renderer->desc.geometry->pose_count;
    return scene_gpu_update(&renderer->scene, renderer->desc.geometry) &&
           caster_pool_update(renderer->casters) && renderer_set_light(renderer, light);
}

bool renderer_reload_shaders(struct renderer *renderer) {
    return change(renderer, &renderer->desc, PART_SHADERS);
}

/* --- the frame --- */

struct frame renderer_frame(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    struct frame frame = {
        .timers = &renderer->timers,
        .view = &renderer->view_buffer,
        .light = &renderer->light_buffer,
        .scene = &renderer->scene,
        .caster = renderer->caster,
        .light_measure = renderer->light_block.measure,
        .light_directional = desc->light.type == EMITTER_DIRECTIONAL,
        .light_views = emitter_view_count(&desc->light),
        .radius = desc->geometry->radius,
        .irradiance_scale = irradiance_scale(desc),
    };
    memcpy(frame.bounds_min, desc->geometry->bounds_min, sizeof frame.bounds_min);
    memcpy(frame.bounds_max, desc->geometry->bounds_max, sizeof frame.bounds_max);
    return frame;
}

struct composite_inputs renderer_composite_inputs(const struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    struct technique_outputs outputs;
    renderer_outputs(renderer, &outputs);
    struct composite_inputs inputs = {
        .gbuffer = &renderer->gbuffer,
        .direct = &renderer->direct.direct,
        .indirect = outputs.irradiance,
        .picks = &renderer->antialias.picks,
        .samples = renderer->antialias.samples,
        .exposure = desc->settings.exposure,
        .tone_map = (enum tone_map)desc->settings.tone_map,
        .layer = LAYER_BEAUTY,
    };
    for (int i = 0; i < 3; i++)
        inputs.light[i] =
            desc->light.intensity[i] / ((float)GLM_PI * renderer->light_block.direct_scale);
    return inputs;
}

static void render_lights(struct renderer *renderer, const struct frame *frame) {
    if (renderer->lights_drawn && renderer->desc.keep_lights)
        return;
    shadow_map_pass_render(&renderer->shadow_map, frame);
    renderer->technique->render_lights(renderer->technique_state, frame);
    renderer->lights_drawn = true;
}

void renderer_render(struct renderer *renderer) {
    struct frame frame = renderer_frame(renderer);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    timer_begin(&renderer->timers, "frame");
    render_lights(renderer, &frame);
    geometry_pass_render_camera(&renderer->geometry, &frame, &renderer->gbuffer);
    direct_pass_render(&renderer->direct, &frame, &renderer->gbuffer, &renderer->shadow_map.map);
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

void renderer_outputs(const struct renderer *renderer, struct technique_outputs *outputs) {
    renderer->technique->outputs(renderer->technique_state, outputs);
}
