#include "passes/composite.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/params.h"

#include <cglm/util.h>

#include <math.h>

bool composite_pass_init(struct composite_pass *pass, const struct composite_desc *desc) {
    *pass = (struct composite_pass){.desc = *desc};
    if (program_init(
            &pass->display_program,
            &(struct program_desc){.vertex = "fullscreen.vert", .fragment = "composite.frag"}) &&
        program_init(&pass->layer_program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                                  .fragment = "layer.frag"}) &&
        texture_init(&pass->display, &(struct texture_desc){.label = "display",
                                                            .format = GL_RGBA8,
                                                            .width = desc->width,
                                                            .height = desc->height}) &&
        framebuffer_init(
            &pass->framebuffer,
            &(struct framebuffer_desc){.label = "display", .colors = {&pass->display}}) &&
        buffer_init(&pass->params, "composite parameters", sizeof(struct composite_params), NULL))
        return true;
    composite_pass_free(pass);
    return false;
}

void composite_pass_free(struct composite_pass *pass) {
    program_free(&pass->display_program);
    program_free(&pass->layer_program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->display);
    buffer_free(&pass->params);
    *pass = (struct composite_pass){0};
}

static void draw(const struct composite_pass *pass, const struct frame *frame,
                 const struct composite_inputs *inputs, int layer, GLuint program,
                 GLuint framebuffer) {
    struct composite_params params = {
        .light = {inputs->light[0], inputs->light[1], inputs->light[2], (float)inputs->samples},
        .indirect = 1 / ((float)GLM_PI * frame->irradiance_scale),
        .exposure = exp2f(inputs->exposure),
        .tone_map = (float)inputs->tone_map,
        .layer = (float)layer,
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "composite",
                   .program = program,
                   .framebuffer = framebuffer,
                   .width = pass->desc.width,
                   .height = pass->desc.height,
                   .textures = {{UNIT_GBUFFER_DEPTH, inputs->gbuffer->depth.id},
                                {UNIT_GBUFFER_NORMAL, inputs->gbuffer->normal.id},
                                {UNIT_GBUFFER_ALBEDO, inputs->gbuffer->albedo.id},
                                {UNIT_DIRECT, inputs->direct->id},
                                {UNIT_INDIRECT, inputs->indirect->texture.id},
                                {UNIT_SAMPLE_PICKS, inputs->picks->id}},
                   .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
               });
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

void composite_pass_render(const struct composite_pass *pass, const struct frame *frame,
                           const struct composite_inputs *inputs) {
    draw(pass, frame, inputs, inputs->layer, pass->display_program, pass->framebuffer);
}

void composite_pass_render_layer(const struct composite_pass *pass, const struct frame *frame,
                                 const struct composite_inputs *inputs, int layer,
                                 GLuint framebuffer) {
    draw(pass, frame, inputs, layer, pass->layer_program, framebuffer);
}
