#include "passes/picture/composite.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "scene/lights/environment.h"
#include "shared/composite.h"

#include <cglm/util.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

unsigned composite_kinds(const struct contribution *contribution) {
    return (contribution->irradiance ? HAS_IRRADIANCE : 0U) |
           (contribution->radiance ? HAS_RADIANCE : 0U) |
           (contribution->in_scatter ? HAS_MEDIUM : 0U) |
           (contribution->edge_sample_irradiance ? HAS_EDGE_SAMPLES : 0U) |
           (contribution->caustic ? HAS_CAUSTICS : 0U) |
           (contribution->volume_caustic ? HAS_VOLUME_CAUSTICS : 0U);
}

/* GL promises a program 16 samplers. Of all kinds together 17 are needed: without samplers of their
 * own, edge samples take the irradiance of the pixel that stands in for them. */
static unsigned contributes_within_samplers(const struct composite_desc *desc) {
    const unsigned all = HAS_IRRADIANCE | HAS_RADIANCE | HAS_MEDIUM | HAS_EDGE_SAMPLES |
                         HAS_CAUSTICS | HAS_VOLUME_CAUSTICS;
    bool is_too_much =
        desc->contributes == all && desc->has_sky && desc->has_emission && desc->has_specular;
    return is_too_much ? all & ~(unsigned)HAS_EDGE_SAMPLES : desc->contributes;
}

static bool init_programs(struct composite_pass *pass) {
    unsigned has = contributes_within_samplers(&pass->desc);
    char defines[192], centers[sizeof defines + 8];
    snprintf(defines, sizeof defines, "%s%s%s%s%s%s%s%s%s",
             has & HAS_IRRADIANCE ? "HAS_IRRADIANCE;" : "",
             has & HAS_EDGE_SAMPLES ? "HAS_EDGE_SAMPLES;" : "",
             has & HAS_RADIANCE ? "HAS_RADIANCE;" : "", has & HAS_MEDIUM ? "HAS_MEDIUM;" : "",
             has & HAS_CAUSTICS ? "HAS_CAUSTICS;" : "",
             has & HAS_VOLUME_CAUSTICS ? "HAS_VOLUME_CAUSTICS;" : "",
             pass->desc.has_sky ? "HAS_SKY;" : "", pass->desc.has_emission ? "HAS_EMISSION;" : "",
             pass->desc.has_specular ? "HAS_SPECULAR;" : "");
    snprintf(centers, sizeof centers, "%sCENTERS", defines);
    return program_init(&pass->display_program,
                        &(struct program_desc){
                            .screen = {"passes/picture/composite.frag"},
                            .defines = defines,
                        }) &&
           (program_dispatched(pass->display_program) ||
            program_init(&pass->centers_program,
                         &(struct program_desc){
                             .vertex = "fullscreen.vert",
                             .fragment = "passes/picture/composite.frag",
                             .defines = centers,
                         })) &&
           program_init(&pass->layer_program,
                        &(struct program_desc){
                            .screen = {"passes/picture/layer.frag", .blended = true},
                            .defines = defines,
                        });
}

bool composite_pass_init(struct composite_pass *pass, const struct composite_desc *desc) {
    *pass = (struct composite_pass){.desc = *desc};
    if (init_programs(pass) &&
        texture_init(&pass->display, &(struct texture_desc){.label = "display",
                                                            .format = GL_RGBA8,
                                                            .width = desc->width,
                                                            .height = desc->height}) &&
        texture_init(&pass->edges, &(struct texture_desc){.label = "edges of the display",
                                                          .format = GL_DEPTH_COMPONENT16,
                                                          .width = desc->width,
                                                          .height = desc->height}) &&
        framebuffer_init(&pass->framebuffer, &(struct framebuffer_desc){.label = "display",
                                                                        .colors = {&pass->display},
                                                                        .depth = &pass->edges}) &&
        buffer_init(&pass->params, "composite parameters", sizeof(struct composite_params), NULL))
        return true;
    composite_pass_free(pass);
    return false;
}

void composite_pass_free(struct composite_pass *pass) {
    programs_free(&pass->centers_program, &pass->display_program, &pass->layer_program);
    framebuffer_free(&pass->framebuffer);
    textures_free(&pass->display, &pass->edges);
    buffer_free(&pass->params);
    *pass = (struct composite_pass){0};
}

/* A pass of an accumulated picture may have no edge samples. Its assignment asks for none, but
 * samplers must have a texture. */
static void add_edge_samples(struct pass_state *state, const struct frame *frame,
                             const struct contribution *contribution) {
    const struct irradiance *irradiance = contribution->edge_sample_irradiance;
    const struct texture *texels = contribution->edge_sample_texels;
    irradiance = irradiance ? irradiance : contribution->irradiance;
    texels = texels ? texels : frame->assignment;
    pass_add_texture(state, UNIT_EDGE_SAMPLE_IRRADIANCE, irradiance->texture.id);
    pass_add_texture(state, UNIT_EDGE_SAMPLE_TEXELS, texels->id);
}

static void add_contribution(struct pass_state *state, const struct contribution *contribution) {
    if (contribution->irradiance)
        pass_add_texture(state, UNIT_IRRADIANCE, contribution->irradiance->texture.id);
    if (contribution->radiance)
        pass_add_texture(state, UNIT_RADIANCE, contribution->radiance->id);
    if (contribution->in_scatter) {
        pass_add_texture(state, UNIT_IN_SCATTER, contribution->in_scatter->id);
        pass_add_texture(state, UNIT_TRANSMITTANCE, contribution->transmittance->id);
    }
    if (contribution->caustic)
        pass_add_texture(state, UNIT_CAUSTIC, contribution->caustic->id);
    if (contribution->volume_caustic)
        pass_add_texture(state, UNIT_VOLUME_CAUSTIC, contribution->volume_caustic->id);
}

/* Draws the centres of all pixels, and marks pixels that need samples by depth 0. A software
 * rasteriser executes both sides of a branch, so samples have a second draw; a dispatch does both
 * in one. */
static void draw_centers(const struct composite_pass *pass, struct pass_state state) {
    state.program = pass->centers_program;
    state.depth = PASS_DEPTH_LESS;
    framebuffer_clear_depth(pass->framebuffer, 1);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

static void draw(const struct composite_pass *pass, const struct frame *frame,
                 const struct composite_inputs *inputs, int layer, GLuint program,
                 GLuint framebuffer, float weight) {
    struct composite_params params = {
        .samples = inputs->samples,
        .indirect = 1 / ((float)GLM_PI * frame->irradiance_scale),
        .exposure = exp2f(inputs->exposure),
        .filmic = inputs->tone_map == TONE_MAP_FILMIC,
        .layer = layer,
        .scale = 1 / frame->irradiance_scale,
        .weight = weight,
        .sky_strength = inputs->sky ? inputs->sky->strength : 0,
        .sky_turn = inputs->sky ? glm_rad(inputs->sky->turn) : 0,
        .background = inputs->background.kind,
    };
    memcpy(params.background_colour, inputs->background.colour, sizeof params.background_colour);
    buffer_write(&pass->params, 0, sizeof params, &params);
    struct pass_state state = {
        .name = "composite",
        .program = program,
        .framebuffer = framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .blend = weight > 0 ? PASS_BLEND_ADD : PASS_BLEND_OFF,
        .textures = {{UNIT_GBUFFER_DEPTH, inputs->gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, inputs->gbuffer->normal.id},
                     {UNIT_GBUFFER_ALBEDO, inputs->gbuffer->albedo.id},
                     {UNIT_DIRECT, inputs->direct->id},
                     {UNIT_SAMPLE_ASSIGNMENT, frame->assignment->id},
                     {UNIT_EDGE_SAMPLES, frame->edge_samples->id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
    if (pass->desc.has_sky)
        pass_add_texture(&state, UNIT_SKY, frame->scene->sky.id);
    if (pass->desc.has_emission)
        pass_add_texture(&state, UNIT_GBUFFER_EMISSION, inputs->gbuffer->emission.id);
    if (pass->desc.has_specular)
        pass_add_texture(&state, UNIT_DIRECT_SPECULAR, inputs->direct_specular->id);
    add_contribution(&state, &inputs->contribution);
    if (contributes_within_samplers(&pass->desc) & HAS_EDGE_SAMPLES)
        add_edge_samples(&state, frame, &inputs->contribution);
    timer_begin(frame->timers, state.name);
    if (program == pass->display_program && !program_dispatched(program)) {
        draw_centers(pass, state);
        state.depth = PASS_DEPTH_EQUAL;
    }
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    timer_end(frame->timers);
}

void composite_pass_render(const struct composite_pass *pass, const struct frame *frame,
                           const struct composite_inputs *inputs) {
    draw(pass, frame, inputs, inputs->layer, pass->display_program, pass->framebuffer, 0);
}

void composite_pass_render_layer(const struct composite_pass *pass, const struct frame *frame,
                                 const struct composite_inputs *inputs, int layer,
                                 GLuint framebuffer) {
    draw(pass, frame, inputs, layer, pass->layer_program, framebuffer, 0);
}

void composite_pass_add_layer(const struct composite_pass *pass, const struct frame *frame,
                              const struct composite_inputs *inputs, int layer, float weight,
                              GLuint framebuffer) {
    draw(pass, frame, inputs, layer, pass->layer_program, framebuffer, weight);
}
