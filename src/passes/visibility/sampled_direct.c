#include "passes/visibility/sampled_direct.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/sampled_lights.h"
#include "shared/sampled_light.h"

#include <stdlib.h>

enum {
    SAMPLES = 16,       /* of a pixel with neighbours on its surface */
    ALONE_SAMPLES = 48, /* of a pixel without */
};

static bool init_programs(struct sampled_direct_pass *pass) {
    const struct sampled_direct_desc *desc = &pass->desc;
    const char *specular = desc->specular ? "HAS_SPECULAR" : "";
    char *defines = mem_printf("%s%s", light_defines(desc->medium, desc->slides), specular);
    bool ok =
        program_init(&pass->sample_program,
                     &(struct program_desc){.screen = {"passes/visibility/sampled_direct.frag"},
                                            .defines = defines}) &&
        program_init(&pass->add_program,
                     &(struct program_desc){.screen = {"passes/visibility/sampled_direct_add.frag"},
                                            .defines = specular});
    free(defines);
    return ok;
}

static bool init_light(struct texture *texture, const char *label,
                       const struct sampled_direct_desc *desc) {
    return texture_init(texture, &(struct texture_desc){.label = label,
                                                        .format = GL_RGBA32F,
                                                        .width = desc->width,
                                                        .height = desc->height});
}

static bool init_specular(struct sampled_direct_pass *pass) {
    const struct sampled_direct_desc *desc = &pass->desc;
    return init_light(&pass->exact_specular, "exact specular light", desc) &&
           irradiance_init(&pass->radiance, "specular light of samples", GL_RGBA32F, desc->width,
                           desc->height, 1) &&
           init_light(&pass->specular, "direct specular", desc);
}

/* What is as large as the picture. */
static bool init_targets(struct sampled_direct_pass *pass) {
    const struct sampled_direct_desc *desc = &pass->desc;
    struct framebuffer_desc samples = {.label = "samples", .colors = {&pass->exact}},
                            light = {.label = "direct", .colors = {&pass->light}};
    samples.colors[TARGET_SAMPLED] = &pass->irradiance.texture;
    if (desc->specular) {
        samples.colors[TARGET_SAMPLED_EXACT_SPECULAR] = &pass->exact_specular;
        samples.colors[TARGET_SAMPLED_SPECULAR] = &pass->radiance.texture;
        light.colors[TARGET_DIRECT_SPECULAR] = &pass->specular;
    }
    return irradiance_init(&pass->irradiance, "light of samples", GL_RGBA32F, desc->width,
                           desc->height, 1) &&
           init_light(&pass->exact, "exact light", desc) &&
           init_light(&pass->light, "direct", desc) && (!desc->specular || init_specular(pass)) &&
           framebuffer_init(&pass->sample_framebuffer, &samples) &&
           framebuffer_init(&pass->framebuffer, &light);
}

static void free_targets(struct sampled_direct_pass *pass) {
    framebuffers_free(&pass->sample_framebuffer, &pass->framebuffer);
    irradiance_free(&pass->irradiance);
    irradiance_free(&pass->radiance);
    textures_free(&pass->exact, &pass->exact_specular, &pass->light, &pass->specular);
}

bool sampled_direct_pass_init(struct sampled_direct_pass *pass,
                              const struct sampled_direct_desc *desc) {
    *pass = (struct sampled_direct_pass){.desc = *desc};
    if (caster_pool_acquire_tree(desc->casters, &pass->bvh) && init_programs(pass) &&
        init_targets(pass) &&
        buffer_init(&pass->params, "sampled lights", sizeof(struct sampled_direct_params), NULL))
        return true;
    sampled_direct_pass_free(pass);
    return false;
}

void sampled_direct_pass_free(struct sampled_direct_pass *pass) {
    caster_pool_release_tree(pass->desc.casters, &pass->bvh);
    programs_free(&pass->sample_program, &pass->add_program);
    free_targets(pass);
    buffer_free(&pass->params);
    *pass = (struct sampled_direct_pass){0};
}

DEFINE_RESIZE(sampled_direct_pass, exact, framebuffer)

static struct pass_state state_of(const struct sampled_direct_pass *pass, GLuint program,
                                  GLuint framebuffer) {
    return (struct pass_state){.name = "sampled lights",
                               .program = program,
                               .framebuffer = framebuffer,
                               .width = pass->desc.width,
                               .height = pass->desc.height};
}

void sampled_direct_pass_render(const struct sampled_direct_pass *pass, const struct frame *frame,
                                const struct gbuffer *gbuffer) {
    const struct sampled_direct_params params = {
        .samples = SAMPLES,
        .alone_samples = ALONE_SAMPLES,
        .distance = pass->desc.distance,
        .cosine = pass->desc.cosine,
        .scale = frame->irradiance_scale,
        .turn = frame_turn(frame),
        .pass = frame->pass,
    };
    struct pass_state state = state_of(pass, pass->sample_program, pass->sample_framebuffer);
    pass_add_texture(&state, UNIT_GBUFFER_DEPTH, gbuffer->depth.id);
    pass_add_texture(&state, UNIT_GBUFFER_NORMAL, gbuffer->normal.id);
    pass_add_texture(&state, UNIT_BVH, pass->bvh->buffer.texels);
    if (pass->desc.specular) {
        pass_add_texture(&state, UNIT_GBUFFER_SPECULAR, gbuffer->specular.id);
        pass_add_texture(&state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
    }
    pass_add_block(&state, BLOCK_VIEW, frame->view);
    pass_add_block(&state, BLOCK_PASS, &pass->params);
    sampled_lights_add(frame->sampled, &state);
    frame_add_light(frame, &state);
    buffer_write(&pass->params, 0, sizeof params, &params);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

void sampled_direct_pass_add(const struct sampled_direct_pass *pass, const struct frame *frame,
                             const struct sampled_direct_inputs *inputs) {
    struct pass_state state = state_of(pass, pass->add_program, pass->framebuffer);
    pass_add_texture(&state, UNIT_IRRADIANCE, inputs->irradiance->texture.id);
    pass_add_texture(&state, UNIT_DIRECT, inputs->direct->id);
    pass_add_texture(&state, UNIT_EXACT, pass->exact.id);
    if (pass->desc.specular) {
        pass_add_texture(&state, UNIT_RADIANCE, inputs->radiance->texture.id);
        pass_add_texture(&state, UNIT_DIRECT_SPECULAR, inputs->specular->id);
        pass_add_texture(&state, UNIT_EXACT_SPECULAR, pass->exact_specular.id);
    }
    pass_add_block(&state, BLOCK_PASS, &pass->params);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
