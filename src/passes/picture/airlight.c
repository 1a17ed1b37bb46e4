#include "passes/picture/airlight.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "lights/light_samples.h"
#include "passes/frame.h"
#include "passes/targets.h"

#include <cglm/util.h>

#include <math.h>
#include <stdio.h>

static bool init_programs(struct airlight_pass *pass) {
    bool ok = true;
    for (int kind = 0; ok && kind < AIRLIGHT_KINDS; kind++) {
        char defines[64];
        snprintf(defines, sizeof defines, "%sPANES %d;KIND %d",
                 light_defines(true, pass->desc.slides), pass->desc.panes, kind);
        ok = program_init(
            &pass->programs[kind],
            &(struct program_desc){.screen = {"passes/picture/airlight.frag", .blended = true},
                                   .defines = defines});
    }
    for (int axis = 0; ok && axis < 2; axis++)
        ok = program_init(&pass->blur_programs[axis],
                          &(struct program_desc){.screen = {"passes/picture/airlight_blur.frag"},
                                                 .defines = axis ? "HAS_MEDIUM;LAST" : NULL});
    return ok;
}

/* As large as the picture. */
static struct texture_desc target_desc(const struct airlight_pass *pass, const char *label,
                                       GLenum format) {
    return (struct texture_desc){
        .label = label, .format = format, .width = pass->desc.width, .height = pass->desc.height};
}

static bool init_targets(struct airlight_pass *pass) {
    const struct texture_desc steps = target_desc(pass, "airlight steps", GL_RGBA32F),
                              half = target_desc(pass, "airlight half blurred", GL_RGBA32F),
                              light = target_desc(pass, "airlight", GL_RGBA16F),
                              transmittance = target_desc(pass, "transmittance", GL_RGBA16F);
    return framebuffer_init_target(&pass->steps, &pass->steps_framebuffer, &steps) &&
           framebuffer_init_target(&pass->half_blurred, &pass->half_framebuffer, &half) &&
           texture_init(&pass->in_scatter, &light) &&
           texture_init(&pass->transmittance, &transmittance) &&
           framebuffer_init(&pass->framebuffer,
                            &(struct framebuffer_desc){
                                .label = "airlight",
                                .colors = {[TARGET_RESULT] = &pass->in_scatter,
                                           [TARGET_TRANSMITTANCE] = &pass->transmittance}});
}

static void free_targets(struct airlight_pass *pass) {
    framebuffers_free(&pass->steps_framebuffer, &pass->half_framebuffer, &pass->framebuffer);
    textures_free(&pass->steps, &pass->half_blurred, &pass->in_scatter, &pass->transmittance);
}

DEFINE_RESIZE(airlight_pass, steps, framebuffer)

bool airlight_pass_init(struct airlight_pass *pass, const struct airlight_desc *desc) {
    *pass = (struct airlight_pass){.desc = *desc};
    if (init_programs(pass) && init_targets(pass) &&
        buffer_init(&pass->params, "airlight parameters", sizeof(struct airlight_params), NULL) &&
        buffer_init(&pass->blur_params, "airlight parameters", sizeof(struct airlight_params),
                    NULL))
        return true;
    airlight_pass_free(pass);
    return false;
}

void airlight_pass_free(struct airlight_pass *pass) {
    for (int kind = 0; kind < AIRLIGHT_KINDS; kind++)
        program_free(&pass->programs[kind]);
    for (int axis = 0; axis < 2; axis++)
        program_free(&pass->blur_programs[axis]);
    free_targets(pass);
    buffers_free(&pass->params, &pass->blur_params);
    *pass = (struct airlight_pass){0};
}

/* Fewer would show as noise that the blur does not join. */
enum { LEAST_STEPS = 8 };

/* Light samples of a lamp are spread over it; those of a ball do not grow nearer to them than so
 * much of the radius of their share. */
static const double ball_width = .25;

static void set_source(struct airlight_params *params, int n, const struct emitter *lamp,
                       int samples) {
    enum emitter_shape shape = emitter_shape(lamp);
    bool is_flat = shape == EMITTER_IS_RECTANGLE || shape == EMITTER_IS_DISK;
    double width = shape == EMITTER_IS_CAP ? 0 : sqrt(emitter_extent(lamp) / (GLM_PI * samples));
    float half[2] = {lamp->size[0] / 2, lamp->size[1] / 2};
    params->sources[n][1] = (float)(is_flat ? width : ball_width * width);
    params->sources[n][2] = !is_flat                        ? AIRLIGHT_FLAT_NONE
                            : shape == EMITTER_IS_RECTANGLE ? AIRLIGHT_FLAT_RECTANGLE
                                                            : AIRLIGHT_FLAT_DISK;
    for (int c = 0; c < 3; c++) {
        params->middles[n][c] = lamp->position[c];
        params->rights[n][c] = half[0] * lamp->right[c];
        params->ups[n][c] = half[shape == EMITTER_IS_RECTANGLE] * lamp->up[c];
    }
}

static void write_params(const struct airlight_pass *pass, const struct frame *frame,
                         const struct emitters *whole) {
    struct airlight_params params = {
        .scale = frame->irradiance_scale, .turn = frame_turn(frame), .along = {1, 0}};
    for (int i = 0; i < frame->layout.groups; i++) {
        const struct light_group *group = &frame->groups[i];
        int share = (pass->desc.steps + group->count - 1) / group->count;
        int least = pass->desc.steps < LEAST_STEPS ? pass->desc.steps : LEAST_STEPS;
        for (int n = group->first; n < group->first + group->count; n++) {
            params.sources[n][0] = (float)(share > least ? share : least);
            if (i < whole->count)
                set_source(&params, n, &whole->items[i], group->count);
        }
    }
    buffer_write(&pass->params, 0, sizeof params, &params);
    params.along[0] = 0;
    params.along[1] = 1;
    buffer_write(&pass->blur_params, 0, sizeof params, &params);
}

static int kind_of(const struct light *light) {
    return light->type == LIGHT_TYPE_DIRECTIONAL ? AIRLIGHT_DIRECTIONAL
           : light->view_count > 1               ? AIRLIGHT_POINT
                                                 : AIRLIGHT_SPOT;
}

static void march(const struct airlight_pass *pass, const struct frame *frame,
                  const struct gbuffer *gbuffer, const struct texture maps[LIGHT_MAP_KINDS],
                  int index) {
    const struct light *light = &frame->light_block->sources[index];
    struct pass_state state = {
        .name = "airlight",
        .program = pass->programs[kind_of(light)],
        .framebuffer = pass->steps_framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .blend = index > 0 ? PASS_BLEND_ADD : PASS_BLEND_OFF,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_MAP_DEPTH, maps[frame->light_block->views[light->first_view].kind].id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_PASS, &pass->params}},
    };
    frame_add_light(frame, &state);
    pass_set_state(&state);
    pass_set_int(LOCATION_LIGHT, index);
    pass_draw_fullscreen(1);
}

static void blur(const struct airlight_pass *pass, const struct frame *frame,
                 const struct gbuffer *gbuffer, int axis) {
    pass_set_state(&(struct pass_state){
        .name = "airlight",
        .program = pass->blur_programs[axis],
        .framebuffer = axis ? pass->framebuffer : pass->half_framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_PANES, frame->scene->panes.buffer.texels},
                     {UNIT_AIRLIGHT, axis ? pass->half_blurred.id : pass->steps.id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_MEDIUM, frame->medium},
                   {BLOCK_PASS, axis ? &pass->blur_params : &pass->params}},
    });
    pass_draw_fullscreen(1);
}

void airlight_pass_render(const struct airlight_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer, const struct texture maps[LIGHT_MAP_KINDS],
                          const struct emitters *whole) {
    static const float none[4] = {0};
    timer_begin(frame->timers, "airlight");
    write_params(pass, frame, whole);
    if (frame->light_block->count == 0)
        framebuffer_clear_color(pass->steps_framebuffer, TARGET_RESULT, none);
    for (int i = 0; i < frame->light_block->count; i++)
        march(pass, frame, gbuffer, maps, i);
    blur(pass, frame, gbuffer, 0);
    blur(pass, frame, gbuffer, 1);
    timer_end(frame->timers);
}
