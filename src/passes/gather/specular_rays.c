#include "passes/gather/specular_rays.h"

#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/sampled_lights.h"
#include "shared/gather.h"

#include <math.h>
#include <stdlib.h>

static bool init_program(struct specular_rays_pass *pass) {
    const struct light_layout *lights = &pass->desc.lights;
    int kinds = (lights->views[LIGHT_MAP_SINGLE] > 0) << LIGHT_MAP_SINGLE |
                (lights->views[LIGHT_MAP_FACE] > 0) << LIGHT_MAP_FACE;
    char *defines = mem_printf("%s%s%s%sRECEIVERS %d;ADDS_LATER %d;LIGHTS %d;MAP_KINDS %d",
                               light_defines(pass->desc.medium, pass->desc.slides),
                               lights->sky ? "HAS_SKY;" : "", lights->many ? "HAS_SAMPLED;" : "",
                               pass->desc.by_importance ? "BY_IMPORTANCE;" : "", RECEIVERS_ALL,
                               pass->desc.later, lights->lights, kinds);
    bool ok = program_init(&pass->program, &(struct program_desc){
                                               .screen = {"passes/gather/specular_rays.frag",
                                                          .blended = true, .tiled = true},
                                               .defines = defines,
                                           });
    free(defines);
    return ok;
}

bool specular_rays_pass_init(struct specular_rays_pass *pass,
                             const struct specular_rays_desc *desc) {
    *pass = (struct specular_rays_pass){.desc = *desc};
    if (init_program(pass) &&
        buffer_init(&pass->params, "parameters of rays", sizeof(struct specular_rays_params), NULL))
        return true;
    specular_rays_pass_free(pass);
    return false;
}

void specular_rays_pass_free(struct specular_rays_pass *pass) {
    program_free(&pass->program);
    buffer_free(&pass->params);
    *pass = (struct specular_rays_pass){0};
}

/* In doubles: floats would leave late passes only a few places. */
static float steps(double step, double count) {
    return (float)fmod(step * count, 1);
}

static void write_params(const struct specular_rays_pass *pass, const struct frame *frame,
                         const struct irradiance *radiance) {
    double first = (double)frame->pass * pass->desc.rays;
    struct specular_rays_params params = {
        .pattern = irradiance_pattern(radiance),
        .start = {steps(SPECULAR_STEP_X, first), steps(SPECULAR_STEP_Y, first)},
        .scale = frame->irradiance_scale,
        .farthest = 2 * frame->geometry->radius,
        .rays = pass->desc.rays,
        .vpl_weight = (float)(radiance->interleave * radiance->interleave),
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
}

void specular_rays_pass_render(const struct specular_rays_pass *pass, const struct frame *frame,
                               const struct gbuffer *gbuffer,
                               const struct specular_rays_inputs *inputs) {
    const struct irradiance *radiance = inputs->radiance;
    const struct light_rays rays = {
        .tree = inputs->tree->buffer.texels,
        .albedos = inputs->albedos,
        .sky_pieces = pass->desc.lights.sky ? frame->sky_pieces->id : 0,
    };
    struct pass_state state = {
        .name = "specular rays",
        .program = pass->program,
        .framebuffer = radiance->framebuffer,
        .width = radiance->texture.desc.width,
        .height = radiance->texture.desc.height,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_GBUFFER_ALBEDO, gbuffer->albedo.id},
                     {UNIT_GBUFFER_SPECULAR, gbuffer->specular.id},
                     {UNIT_DIRECT, frame->direct->id},
                     {UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VPL_SHARES, inputs->shares},
                   {BLOCK_PASS, &pass->params}},
    };
    int n = radiance->interleave;
    frame_add_light(frame, &state);
    sampled_lights_add(frame->sampled, &state);
    light_rays_add(&state, &rays);
    rsm_add(&state, inputs->rsm);
    if (pass->desc.later)
        pass_add_texture(&state, UNIT_IRRADIANCE, inputs->irradiance->texture.id);
    if (pass->desc.by_importance)
        pass_add_texture(&state, UNIT_VPL_DENSITY, inputs->importance->densities.id);
    write_params(pass, frame, radiance);
    pass_begin(frame->timers, &state);
    for (int slot = 0; slot < n * n; slot++) {
        irradiance_view_tile(radiance, slot);
        pass_set_ints(LOCATION_SLOT, 0, 0, slot % n, slot / n);
        pass_draw_fullscreen(1);
    }
    pass_end(frame->timers);
}
