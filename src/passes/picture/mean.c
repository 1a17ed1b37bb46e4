#include "passes/picture/mean.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool has_layer(const struct mean_desc *desc, int layer) {
    switch (layer) {
    case LAYER_AIRLIGHT:
        return desc->medium;
    case LAYER_CAUSTIC:
        return desc->caustics;
    case LAYER_VOLUME:
        return desc->volume_caustics;
    default:
        return layer < LAYERS_PLAIN || desc->specular;
    }
}

static bool init_sums(struct mean_pass *pass) {
    bool ok = true;
    for (int i = 0; ok && i < pass->layers; i++)
        ok = !has_layer(&pass->desc, i) ||
             framebuffer_init_target(&pass->sums[i], &pass->framebuffers[i],
                                     &(struct texture_desc){.label = "sum of passes",
                                                            .format = GL_RGBA32F,
                                                            .width = pass->desc.width,
                                                            .height = pass->desc.height});
    return ok;
}

bool mean_pass_init(struct mean_pass *pass, const struct mean_desc *desc) {
    *pass = (struct mean_pass){.desc = *desc, .layers = LAYERS};
    while (!has_layer(desc, pass->layers - 1))
        pass->layers--;
    char layers[32], display_layers[sizeof layers + 8];
    snprintf(layers, sizeof layers, "LAYER_COUNT %d", pass->layers);
    snprintf(display_layers, sizeof display_layers, "DISPLAY;%s", layers);
    /* Drawn: in compute shaders llvmpipe 22.3 reads zeros by an index of sums[] that varies. */
    struct program_desc program = {
        .vertex = "fullscreen.vert", .fragment = "passes/picture/mean.frag", .defines = layers};
    struct program_desc display = program;
    display.defines = display_layers;
    if (program_init(&pass->layer_program, &program) &&
        program_init(&pass->display_program, &display) && init_sums(pass) &&
        buffer_init(&pass->params, "mean parameters", sizeof(struct composite_params), NULL))
        return true;
    mean_pass_free(pass);
    return false;
}

void mean_pass_free(struct mean_pass *pass) {
    programs_free(&pass->layer_program, &pass->display_program);
    for (int i = 0; i < LAYERS; i++) {
        framebuffer_free(&pass->framebuffers[i]);
        texture_free(&pass->sums[i]);
    }
    buffer_free(&pass->params);
    *pass = (struct mean_pass){0};
}

void mean_pass_clear(const struct mean_pass *pass) {
    static const float zero[4] = {0};
    for (int i = 0; i < pass->layers; i++)
        if (pass->framebuffers[i])
            framebuffer_clear_color(pass->framebuffers[i], TARGET_RESULT, zero);
}

static void draw(const struct mean_pass *pass, const struct frame *frame, GLuint program,
                 const struct composite_params *params, GLuint framebuffer) {
    struct pass_state state = {
        .name = "composite",
        .program = program,
        .framebuffer = framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .blocks = {{BLOCK_PASS, &pass->params}},
    };
    for (GLuint i = 0; i < (GLuint)pass->layers; i++) /* drivers warn of empty units */
        pass_add_texture(&state, UNIT_LAYER_SUMS + i, pass->sums[pass->framebuffers[i] ? i : 0].id);
    buffer_write(&pass->params, 0, sizeof *params, params);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

void mean_pass_render_display(const struct mean_pass *pass, const struct frame *frame,
                              double weight, int layer, float exposure, bool filmic,
                              const struct background *background, GLuint framebuffer) {
    struct composite_params params = {.layer = layer,
                                      .weight = (float)weight,
                                      .exposure = exp2f(exposure),
                                      .filmic = filmic,
                                      .background = background->kind};
    memcpy(params.background_colour, background->colour, sizeof params.background_colour);
    draw(pass, frame, pass->display_program, &params, framebuffer);
}

void mean_pass_render_layer(const struct mean_pass *pass, const struct frame *frame, double weight,
                            int layer, GLuint framebuffer) {
    struct composite_params params = {.layer = layer, .weight = (float)weight};
    draw(pass, frame, pass->layer_program, &params, framebuffer);
}
