#include "renderer/renderer.h"

#include "shared/params.h"

#include <cglm/util.h>

#include <math.h>
#include <string.h>

/* A power of two near the irradiance that the light could make across the scene, inverted: exact to
 * multiply by, and keeps half floats in range whatever the units. */
static float irradiance_scale(const struct renderer_desc *desc) {
    const struct light *light = &desc->light;
    float brightest = fmaxf(light->intensity[0], fmaxf(light->intensity[1], light->intensity[2]));
    float radius = desc->geometry->radius;
    float typical = light->type == LIGHT_DIRECTIONAL ? brightest : brightest / (radius * radius);
    return typical > 0 && isfinite(typical) ? exp2f(-roundf(log2f(typical))) : 1;
}

static bool init_passes(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    int light_views = light_view_count(&desc->light);
    return gbuffer_init(&renderer->gbuffer, "g-buffer", desc->width, desc->height, 1) &&
           geometry_pass_init(&renderer->geometry) &&
           direct_pass_init(&renderer->direct,
                            &(struct direct_desc){
                                .width = desc->width,
                                .height = desc->height,
                                .shadow_size = desc->settings.shadow_size,
                                .light_views = light_views,
                                .bias = desc->settings.shadow_bias,
                            }) &&
           renderer->technique->init(&renderer->technique_state,
                                     &(struct technique_desc){
                                         .settings = &desc->settings,
                                         .width = desc->width,
                                         .height = desc->height,
                                         .light_views = light_views,
                                     }) &&
           composite_pass_init(&renderer->composite,
                               &(struct composite_desc){desc->width, desc->height});
}

bool renderer_init(struct renderer *renderer, const struct renderer_desc *desc) {
    *renderer = (struct renderer){.desc = *desc, .technique = techniques[desc->technique]};
    timers_init(&renderer->timers, desc->timed, desc->software);
    view_of_camera(&renderer->camera_view, &desc->camera, desc->geometry,
                   (float)desc->width / (float)desc->height);
    view_of_light(&renderer->light_block, &desc->light, desc->geometry);
    caster_init(&renderer->caster, desc->geometry,
                desc->settings.caster_edge * desc->geometry->radius);
    if (scene_gpu_init(&renderer->scene, desc->scene, desc->geometry, &renderer->caster) &&
        init_passes(renderer) &&
        buffer_init(&renderer->view_buffer, "view", sizeof renderer->camera_view,
                    &renderer->camera_view) &&
        buffer_init(&renderer->light_buffer, "light", sizeof renderer->light_block,
                    &renderer->light_block))
        return true;
    renderer_free(renderer);
    return false;
}

void renderer_free(struct renderer *renderer) {
    timers_free(&renderer->timers);
    caster_free(&renderer->caster);
    scene_gpu_free(&renderer->scene);
    gbuffer_free(&renderer->gbuffer);
    geometry_pass_free(&renderer->geometry);
    direct_pass_free(&renderer->direct);
    composite_pass_free(&renderer->composite);
    if (renderer->technique)
        renderer->technique->free(renderer->technique_state);
    buffer_free(&renderer->view_buffer);
    buffer_free(&renderer->light_buffer);
    *renderer = (struct renderer){0};
}

struct frame renderer_frame(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    struct frame frame = {
        .timers = &renderer->timers,
        .scene = &renderer->scene,
        .light_views = light_view_count(&desc->light),
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
        .exposure = desc->settings.exposure,
        .tone_map = (enum tone_map)desc->settings.tone_map,
        .layer = LAYER_BEAUTY,
    };
    for (int i = 0; i < 3; i++)
        inputs.light[i] =
            desc->light.intensity[i] / ((float)GLM_PI * renderer->light_block.direct_scale);
    return inputs;
}

void renderer_bind_frame(const struct renderer *renderer) {
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_VIEW, renderer->view_buffer.id);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_LIGHT, renderer->light_buffer.id);
}

void renderer_render(struct renderer *renderer) {
    struct frame frame = renderer_frame(renderer);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    timer_begin(&renderer->timers, "frame");
    renderer_bind_frame(renderer);
    geometry_pass_render_camera(&renderer->geometry, &frame, &renderer->gbuffer);
    direct_pass_render(&renderer->direct, &frame, &renderer->gbuffer);
    renderer->technique->render(renderer->technique_state, &frame, &renderer->gbuffer);
    composite_pass_render(&renderer->composite, &frame, &inputs);
    timer_end(&renderer->timers);
}

void renderer_outputs(const struct renderer *renderer, struct technique_outputs *outputs) {
    renderer->technique->outputs(renderer->technique_state, outputs);
}
