#include "passes/gather/near_field.h"

#include "base/halton.h"
#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/near_field.h"

#include <math.h>
#include <stdlib.h>

/* As many samples as each slot may have of its own; fewer slots' worth are shared. */
static int pattern_count(const struct near_field_desc *desc) {
    int slots = desc->interleave * desc->interleave, most = NEAR_SAMPLES_MAX / desc->samples;
    return slots < most ? slots : most;
}

static bool upload_samples(struct near_field_pass *pass) {
    struct near_sample samples[NEAR_SAMPLES_MAX];
    for (uint32_t i = 0; i < NEAR_SAMPLES_MAX; i++) {
        double turn = 2 * acos(-1) * radical_inverse(3, i);
        samples[i] = (struct near_sample){
            .direction = {(float)cos(turn), (float)sin(turn)},
            .log_radius = (float)radical_inverse(2, i),
        };
    }
    return buffer_init(&pass->samples, "near field samples", sizeof samples, samples);
}

static bool init_programs(struct near_field_pass *pass) {
    char *defines = mem_printf("LIGHT_VIEWS %d", pass->desc.light_views);
    bool ok =
        program_init(&pass->light_program,
                     &(struct program_desc){
                         .vertex = "layers.vert",
                         .fragment = "gather/near_light.frag",
                     }) &&
        program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                            .fragment = "gather/near_field.frag",
                                                            .defines = defines});
    free(defines);
    return ok;
}

static bool init_lights(struct near_field_pass *pass) {
    return texture_init(&pass->lights,
                        &(struct texture_desc){
                            .label = "near lights",
                            .target = GL_TEXTURE_2D_ARRAY,
                            .format = GL_RGBA32UI,
                            .width = pass->desc.rsm_size,
                            .height = pass->desc.rsm_size,
                            .layers = pass->desc.light_views,
                        }) &&
           framebuffer_init(
               &pass->lights_framebuffer,
               &(struct framebuffer_desc){.label = "near lights", .colors = {&pass->lights}});
}

bool near_field_pass_init(struct near_field_pass *pass, const struct near_field_desc *desc) {
    *pass = (struct near_field_pass){.desc = *desc};
    if (init_programs(pass) && init_lights(pass) && upload_samples(pass) &&
        buffer_init(&pass->params, "near field parameters", sizeof(struct near_field_params), NULL))
        return true;
    near_field_pass_free(pass);
    return false;
}

void near_field_pass_free(struct near_field_pass *pass) {
    program_free(&pass->light_program);
    program_free(&pass->program);
    texture_free(&pass->lights);
    framebuffer_free(&pass->lights_framebuffer);
    buffer_free(&pass->samples);
    buffer_free(&pass->params);
    *pass = (struct near_field_pass){0};
}

static void write_params(const struct near_field_pass *pass, const struct frame *frame,
                         struct interleaving pattern) {
    struct near_field_params params = {
        .pattern = pattern,
        .vpl_share = frame->light_measure / (float)pass->desc.vpl_count,
        .reach = frame_near_reach(frame, pass->desc.vpl_count, pass->desc.reach),
        .power_scale = frame->irradiance_scale / (frame->radius * frame->radius),
        .inverse_radius = 1 / frame->radius,
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
}

void near_field_pass_render_light(const struct near_field_pass *pass, const struct frame *frame,
                                  const struct gbuffer *rsm) {
    write_params(pass, frame, (struct interleaving){.n = 1});
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "near light",
                   .program = pass->light_program,
                   .framebuffer = pass->lights_framebuffer,
                   .width = pass->desc.rsm_size,
                   .height = pass->desc.rsm_size,
                   .textures = {{UNIT_RSM_DEPTH, rsm->depth.id},
                                {UNIT_RSM_NORMAL, rsm->normal.id},
                                {UNIT_RSM_ALBEDO, rsm->albedo.id}},
                   .blocks = {{BLOCK_LIGHT, frame->light}, {BLOCK_PASS, &pass->params}},
               });
    pass_draw_fullscreen(pass->desc.light_views);
    pass_end(frame->timers);
}

void near_field_pass_render(const struct near_field_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct irradiance *irradiance) {
    int n = irradiance->interleave, patterns = pattern_count(&pass->desc);
    write_params(pass, frame, irradiance_pattern(irradiance));
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "near field",
                                  .program = pass->program,
                                  .framebuffer = irradiance->framebuffer,
                                  .width = irradiance->texture.desc.width,
                                  .height = irradiance->texture.desc.height,
                                  .blend = PASS_BLEND_ADD,
                                  .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                               {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                                               {UNIT_NEAR_LIGHT, pass->lights.id}},
                                  .blocks = {{BLOCK_VIEW, frame->view},
                                             {BLOCK_LIGHT, frame->light},
                                             {BLOCK_PASS, &pass->params},
                                             {BLOCK_NEAR_SAMPLES, &pass->samples}},
                              });
    for (int slot = 0; slot < n * n; slot++) {
        pass_viewport(slot % n * irradiance->tile_width, slot / n * irradiance->tile_height,
                      irradiance->tile_width, irradiance->tile_height);
        gl.ProgramUniform4i(pass->program, LOCATION_SLOT, slot % patterns * pass->desc.samples,
                            pass->desc.samples, slot % n, slot / n);
        pass_draw_fullscreen(1);
    }
    pass_end(frame->timers);
}
