#include "passes/caustics/glass.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "scene/lights/environment.h"
#include "scene/mesh/triangle_albedos.h"
#include "shared/smooth.h"

#include <cglm/util.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What lies so near a surface of the picture is that surface, over the scene's radius. */
static const float reach = 3e-3F;

/* For the indirect light of a place outside the picture. */
enum { RAYS = 4 };

/* --- triangles -------------------------------------------------------------------------------- */

static size_t glow_size(const struct glass_pass *pass) {
    return (size_t)pass->desc.scene->material_count * sizeof *pass->glow;
}

static void add_glow(const struct glass_pass *pass, const struct geometry *geometry,
                     float (*texels)[4]) {
    for (int b = 0; b < geometry->batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        const struct material *material = &pass->desc.scene->materials[batch->material];
        for (uint32_t i = 0; i < batch->index_count / 3; i++)
            for (int c = 0; c < 3; c++)
                texels[2 * (batch->first_index / 3 + i) + 1][c] =
                    pass->glow[batch->material][c] *
                    (material->unlit ? material->base_color[c] : 1);
    }
}

static bool init_triangles(struct glass_pass *pass, const struct geometry *geometry) {
    size_t count = geometry->index_count / 3;
    struct triangle_albedo *albedos = mem_alloc(count, sizeof *albedos);
    float(*texels)[4] = mem_alloc(2 * count, sizeof *texels);
    struct surface_colors colors = {.scene = pass->desc.scene,
                                    .geometry = geometry,
                                    .materials = pass->desc.materials,
                                    .smooth_black = true};
    texture_decode_table(colors.srgb_to_linear);
    triangle_albedos_find(albedos, &colors);
    for (size_t i = 0; i < count; i++)
        glm_vec4(albedos[i].color, albedos[i].backs, texels[2 * i]);
    add_glow(pass, geometry, texels);
    bool ok = buffer_init_texels(&pass->triangles, GL_RGBA32F, "triangles that glass shows",
                                 2 * count * sizeof *texels, texels);
    mem_free(albedos, texels);
    pass->painted = geometry->painted;
    return ok;
}

/* Where there is no memory for metaballs that have grown, what they reflect is black. */
static void follow(struct glass_pass *pass, const struct frame *frame) {
    bool glows_alike = memcmp(pass->glow, frame->scene->glow, glow_size(pass)) == 0;
    if (pass->painted == frame->geometry->painted && glows_alike)
        return;
    memcpy(pass->glow, frame->scene->glow, glow_size(pass));
    buffer_free(&pass->triangles);
    init_triangles(pass, frame->geometry);
}

/* --- life ------------------------------------------------------------------------------------- */

static bool init_targets(struct glass_pass *pass) {
    return framebuffer_init_target(&pass->screen, &pass->screen_framebuffer,
                                   &(struct texture_desc){.format = GL_RGBA32F,
                                                          .label = "light that glass shows",
                                                          .width = pass->desc.width,
                                                          .height = pass->desc.height});
}

static void free_targets(struct glass_pass *pass) {
    framebuffer_free(&pass->screen_framebuffer);
    texture_free(&pass->screen);
}

DEFINE_RESIZE(glass_pass, screen, screen_framebuffer)

static bool init_program(struct glass_pass *pass) {
    const struct glass_desc *desc = &pass->desc;
    char defines[48];
    snprintf(defines, sizeof defines, "%s%s",
             light_defines(desc->medium, desc->scene->slide_count > 0),
             desc->sky ? "HAS_SKY;" : "");
    return program_init(&pass->program,
                        &(struct program_desc){.vertex = "fullscreen.vert",
                                               .fragment = "passes/caustics/glass.frag",
                                               .defines = defines});
}

bool glass_pass_init(struct glass_pass *pass, const struct glass_desc *desc) {
    *pass = (struct glass_pass){.desc = *desc};
    pass->glow = mem_alloc((size_t)desc->scene->material_count, sizeof *pass->glow);
    if (init_program(pass) && init_targets(pass) && init_triangles(pass, desc->geometry) &&
        buffer_init(&pass->params, "parameters of glass", sizeof(struct glass_params), NULL))
        return true;
    glass_pass_free(pass);
    return false;
}

void glass_pass_free(struct glass_pass *pass) {
    program_free(&pass->program);
    free_targets(pass);
    buffers_free(&pass->triangles, &pass->params);
    free(pass->glow);
    *pass = (struct glass_pass){0};
}

/* --- the frame -------------------------------------------------------------------------------- */

static void write_params(const struct glass_pass *pass, const struct frame *frame,
                         const struct environment *sky) {
    struct glass_params params = {
        .reach = reach * frame->geometry->radius,
        .scale = 1 / frame->irradiance_scale,
        .chains = pass->desc.chains,
        .rays = RAYS,
        .pass = frame->pass,
    };
    if (sky) {
        params.sky_strength = sky->strength;
        params.sky_turn = glm_rad(sky->turn);
    }
    buffer_write(&pass->params, 0, sizeof params, &params);
}

void glass_pass_render(struct glass_pass *pass, const struct frame *frame,
                       const struct gbuffer *gbuffer, const struct glass_inputs *inputs) {
    follow(pass, frame);
    write_params(pass, frame, inputs->sky);
    struct pass_state state = {
        .name = "glass",
        .program = pass->program,
        .framebuffer = inputs->framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .textures = {{UNIT_BVH, inputs->tree->buffer.texels},
                     {UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_GBUFFER_ALBEDO, gbuffer->albedo.id},
                     {UNIT_GLASS_TRIANGLES, pass->triangles.texels},
                     {UNIT_GLASS_SCREEN, pass->screen.id}},
        .blocks = {{BLOCK_PASS, &pass->params},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VIEW, frame->view}},
    };
    smooth_surfaces_add(inputs->surfaces, &state);
    if (pass->desc.sky)
        pass_add_texture(&state, UNIT_GLASS_SKY, frame->scene->sky.id);
    frame_add_light(frame, &state);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
