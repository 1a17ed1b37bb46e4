#include "passes/picture/show_panes.h"

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "scene/lights/environment.h"
#include "shared/show_panes.h"

#include <cglm/util.h>
#include <stdio.h>

static bool init_targets(struct show_panes_pass *pass) {
    const struct texture_desc desc = {.label = "light of panes",
                                      .format = GL_RGBA16F,
                                      .width = pass->desc.width,
                                      .height = pass->desc.height};
    return (!pass->desc.reflects ||
            gbuffer_init(&pass->surfaces,
                         &(struct gbuffer_desc){.label = "pane surfaces",
                                                .width = desc.width,
                                                .height = desc.height,
                                                .layers = 1,
                                                .has_specular = pass->desc.specular})) &&
           texture_init(&pass->own, &desc) && texture_init(&pass->transmittance, &desc) &&
           framebuffer_init(&pass->framebuffer,
                            &(struct framebuffer_desc){
                                .label = "panes",
                                .colors = {[TARGET_RESULT] = &pass->own,
                                           [TARGET_TRANSMITTANCE] = &pass->transmittance}});
}

static void free_targets(struct show_panes_pass *pass) {
    framebuffer_free(&pass->framebuffer);
    textures_free(&pass->own, &pass->transmittance);
    gbuffer_free(&pass->surfaces);
}

DEFINE_RESIZE(show_panes_pass, framebuffer, surfaces)

static bool init_surfaces_program(struct show_panes_pass *pass) {
    return !pass->desc.reflects ||
           program_init(&pass->surfaces_program,
                        &(struct program_desc){.vertex = "fullscreen.vert",
                                               .fragment = "passes/picture/pane_surfaces.frag",
                                               .defines = pass->desc.specular
                                                              ? "HAS_MEDIUM;HAS_SPECULAR"
                                                              : "HAS_MEDIUM"});
}

bool show_panes_pass_init(struct show_panes_pass *pass, const struct show_panes_desc *desc) {
    char defines[96];
    *pass = (struct show_panes_pass){.desc = *desc};
    snprintf(defines, sizeof defines, "%s%s%s%s%s", light_defines(true, desc->slides),
             desc->scatters ? "HAS_AIRLIGHT;" : "", desc->sky ? "HAS_SKY;" : "",
             desc->reflects ? "HAS_SURFACES;" : "",
             desc->reflects && desc->irradiance ? "HAS_IRRADIANCE;" : "");
    if (program_init(&pass->program,
                     &(struct program_desc){.vertex = "fullscreen.vert",
                                            .fragment = "passes/picture/show_panes.frag",
                                            .defines = defines}) &&
        init_surfaces_program(pass) && init_targets(pass) &&
        buffer_init(&pass->params, "parameters of panes", sizeof(struct show_panes_params), NULL) &&
        caster_pool_acquire_tree(desc->casters, &pass->tree))
        return true;
    show_panes_pass_free(pass);
    return false;
}

void show_panes_pass_free(struct show_panes_pass *pass) {
    if (pass->tree)
        caster_pool_release_tree(pass->desc.casters, &pass->tree);
    programs_free(&pass->program, &pass->surfaces_program);
    free_targets(pass);
    buffer_free(&pass->params);
    *pass = (struct show_panes_pass){0};
}

void show_panes_pass_render_surfaces(const struct show_panes_pass *pass, const struct frame *frame,
                                     const struct gbuffer *gbuffer) {
    static const float zero[4] = {0};
    struct pass_state state = {
        .name = "pane surfaces",
        .program = pass->surfaces_program,
        .framebuffer = pass->surfaces.framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .depth = PASS_DEPTH_GREATER,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view}},
    };
    frame_add_medium(frame, &state);
    pass_begin(frame->timers, &state);
    framebuffer_clear_color(state.framebuffer, TARGET_GBUFFER_NORMAL, zero);
    framebuffer_clear_color(state.framebuffer, TARGET_GBUFFER_ALBEDO, zero);
    if (pass->desc.specular)
        framebuffer_clear_color(state.framebuffer, TARGET_GBUFFER_SPECULAR, zero);
    framebuffer_clear_depth(state.framebuffer, 0);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

void show_panes_pass_render(const struct show_panes_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct contribution *contribution,
                            const struct texture *direct, const struct environment *sky) {
    struct show_panes_params params = {.scale = frame->irradiance_scale,
                                       .sky_strength = sky ? sky->strength : 0,
                                       .sky_turn = sky ? glm_rad(sky->turn) : 0};
    buffer_write(&pass->params, 0, sizeof params, &params);
    struct pass_state state = {
        .name = "panes",
        .program = pass->program,
        .framebuffer = pass->framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .textures = {{UNIT_BVH, pass->tree->buffer.texels},
                     {UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_PASS, &pass->params},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VIEW, frame->view}},
    };
    if (pass->desc.scatters) {
        pass_add_texture(&state, UNIT_BEHIND_IN_SCATTER, contribution->in_scatter->id);
        pass_add_texture(&state, UNIT_BEHIND_TRANSMITTANCE, contribution->transmittance->id);
    }
    if (pass->desc.sky)
        pass_add_texture(&state, UNIT_PANES_SKY, frame->scene->sky.id);
    if (pass->desc.reflects)
        pass_add_texture(&state, UNIT_DIRECT, direct->id);
    if (pass->desc.reflects && pass->desc.irradiance)
        pass_add_texture(&state, UNIT_IRRADIANCE, contribution->irradiance->texture.id);
    frame_add_light(frame, &state);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
