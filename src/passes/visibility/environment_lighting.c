#include "passes/visibility/environment_lighting.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "scene/lights/environment.h"
#include "shared/sky.h"

#include <stdlib.h>

/* Of many lights each has so little that no pixel would ask for it: beyond so many the limit falls
 * with what one of them has. */
static const int few = 60;

/* Rays of a pixel's lobe. */
enum { LOBE_RAYS = 4 };

static float disagree_of(const struct environment_lighting_desc *desc) {
    int count = desc->lights;
    return count > few ? desc->disagree * (float)few / (float)count : desc->disagree;
}

static struct environment_lighting_params params_of(const struct environment_lighting_desc *desc,
                                                    const struct frame *frame) {
    const struct environment *sky = frame->emitters->sky;
    return (struct environment_lighting_params){.count = desc->lights,
                                                .block = desc->block,
                                                .disagree = disagree_of(desc),
                                                .pass = frame->pass,
                                                .sky_strength = sky->strength,
                                                .sky_turn = glm_rad(sky->turn),
                                                .scale = frame->irradiance_scale};
}

static bool init_programs(struct environment_lighting_pass *pass) {
    char *defines =
        mem_printf("SUNS %d;BRIGHT %d;SHADOW_RAYS %d%s", pass->desc.suns, pass->desc.bright,
                   pass->desc.shadow_rays, pass->desc.medium ? ";HAS_MEDIUM" : "");
    char *light_defines = mem_printf("%s%s", defines, pass->desc.specular ? ";HAS_SPECULAR" : "");
    bool ok =
        program_init(&pass->share_program,
                     &(struct program_desc){
                         .screen = {"passes/visibility/sky_shares.frag", .layers = true}}) &&
        program_init(
            &pass->block_program,
            &(struct program_desc){.screen = {"passes/visibility/sky_blocks.frag", .layers = true},
                                   .defines = defines}) &&
        program_init(&pass->light_program,
                     &(struct program_desc){
                         .screen = {"passes/visibility/environment_lighting.frag", .blended = true},
                         .defines = light_defines});
    if (ok && pass->desc.specular) {
        char *lobe_defines = mem_printf("%s;LOBE_RAYS %d", defines, LOBE_RAYS);
        ok = program_init(&pass->lobe_program,
                          &(struct program_desc){.screen = {"passes/visibility/sky_lobes.frag"},
                                                 .defines = lobe_defines});
        free(lobe_defines);
    }
    mem_free(defines, light_defines);
    return ok;
}

static int layers(const struct environment_lighting_desc *desc) {
    return (desc->lights + SKY_LAYER_LIGHTS - 1) / SKY_LAYER_LIGHTS;
}

static bool init_shares(struct environment_lighting_pass *pass) {
    return framebuffer_init_target(&pass->shares, &pass->share_framebuffer,
                                   &(struct texture_desc){.label = "sky shares",
                                                          .target = GL_TEXTURE_2D_ARRAY,
                                                          .format = GL_RGBA32F,
                                                          .width = SKY_SHARES_SIZE,
                                                          .height = SKY_SHARES_SIZE,
                                                          .layers = layers(&pass->desc) + 1,
                                                          .filter = FILTER_LINEAR});
}

static bool init_light(struct environment_lighting_pass *pass, struct texture *texture,
                       const char *label) {
    return texture_init(texture, &(struct texture_desc){.label = label,
                                                        .format = GL_RGBA32F,
                                                        .width = pass->desc.width,
                                                        .height = pass->desc.height});
}

static bool init_lobes(struct environment_lighting_pass *pass) {
    const struct environment_lighting_desc *desc = &pass->desc;
    return init_light(pass, &pass->specular, "environment lighting, specular") &&
           irradiance_init(&pass->lobes, "sky in lobes", GL_RGBA32F, desc->width, desc->height, 1);
}

/* What is as large as the picture. */
static bool init_targets(struct environment_lighting_pass *pass) {
    const struct environment_lighting_desc *desc = &pass->desc;
    struct framebuffer_desc light = {.label = "environment lighting", .colors = {&pass->light}};
    if (desc->specular)
        light.colors[TARGET_DIRECT_SPECULAR] = &pass->specular;
    return framebuffer_init_target(
               &pass->blocks, &pass->block_framebuffer,
               &(struct texture_desc){.label = "sky blocks",
                                      .target = GL_TEXTURE_2D_ARRAY,
                                      .format = GL_RGBA8,
                                      .width = (desc->width + desc->block - 1) / desc->block,
                                      .height = (desc->height + desc->block - 1) / desc->block,
                                      .layers = layers(desc)}) &&
           init_light(pass, &pass->light, "environment lighting") &&
           (!desc->specular || init_lobes(pass)) &&
           framebuffer_init(&pass->light_framebuffer, &light);
}

static void free_targets(struct environment_lighting_pass *pass) {
    framebuffers_free(&pass->block_framebuffer, &pass->light_framebuffer);
    textures_free(&pass->blocks, &pass->light, &pass->specular);
    irradiance_free(&pass->lobes);
}

bool environment_lighting_pass_init(struct environment_lighting_pass *pass,
                                    const struct environment_lighting_desc *desc) {
    *pass = (struct environment_lighting_pass){.desc = *desc};
    if (caster_pool_acquire_tree(desc->casters, &pass->bvh) && init_programs(pass) &&
        init_shares(pass) && init_targets(pass) &&
        buffer_init(&pass->params, "sky parameters", sizeof(struct environment_lighting_params),
                    NULL))
        return true;
    environment_lighting_pass_free(pass);
    return false;
}

void environment_lighting_pass_free(struct environment_lighting_pass *pass) {
    caster_pool_release_tree(pass->desc.casters, &pass->bvh);
    programs_free(&pass->share_program, &pass->block_program, &pass->lobe_program,
                  &pass->light_program);
    free_targets(pass);
    framebuffer_free(&pass->share_framebuffer);
    texture_free(&pass->shares);
    buffer_free(&pass->params);
    *pass = (struct environment_lighting_pass){0};
}

DEFINE_RESIZE(environment_lighting_pass, block_framebuffer, lobes)

void environment_lighting_pass_render_lights(const struct environment_lighting_pass *pass,
                                             const struct frame *frame,
                                             const struct buffer *lights) {
    struct environment_lighting_params params = params_of(&pass->desc, frame);
    buffer_write(&pass->params, 0, sizeof params, &params);
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "sky shares",
                                  .program = pass->share_program,
                                  .framebuffer = pass->share_framebuffer,
                                  .width = SKY_SHARES_SIZE,
                                  .height = SKY_SHARES_SIZE,
                                  .blocks = {{BLOCK_SKY, lights}, {BLOCK_PASS, &pass->params}},
                              });
    pass_draw_fullscreen(layers(&pass->desc) + 1);
    pass_end(frame->timers);
}

static void draw_blocks(const struct environment_lighting_pass *pass, const struct frame *frame,
                        struct pass_state *state) {
    state->name = "sky blocks";
    state->program = pass->block_program;
    state->framebuffer = pass->block_framebuffer;
    state->width = pass->blocks.desc.width;
    state->height = pass->blocks.desc.height;
    pass_begin(frame->timers, state);
    pass_draw_fullscreen(layers(&pass->desc));
    pass_end(frame->timers);
}

/* llvmpipe ends the loops of a shader after 65,535 steps in all, of which a ray takes hundreds in a
 * large scene. */
static int layers_of_draw(const struct environment_lighting_desc *desc) {
    static const int rays = 128;
    int most = rays / (SKY_LAYER_LIGHTS * desc->shadow_rays);
    return most < 1 ? 1 : most > SKY_DRAW_LAYERS ? SKY_DRAW_LAYERS : most;
}

static void draw_light(const struct environment_lighting_pass *pass, const struct frame *frame,
                       struct pass_state *state) {
    state->name = "environment lighting";
    state->program = pass->light_program;
    state->framebuffer = pass->light_framebuffer;
    state->width = pass->light.desc.width;
    state->height = pass->light.desc.height;
    timer_begin(frame->timers, state->name);
    int count = layers_of_draw(&pass->desc);
    for (int first = 0; first < layers(&pass->desc); first += count) {
        state->blend = first > 0 ? PASS_BLEND_ADD : PASS_BLEND_OFF;
        pass_set_state(state);
        pass_set_ints(LOCATION_SKY_LAYERS, first, count, 0, 0);
        pass_draw_fullscreen(1);
    }
    timer_end(frame->timers);
}

/* Returns the state that passes over the G-buffer share, and writes their parameters. */
static struct pass_state begin_view(const struct environment_lighting_pass *pass,
                                    const struct frame *frame, const struct gbuffer *gbuffer,
                                    const struct buffer *lights) {
    struct pass_state state = {
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_BVH, pass->bvh->buffer.texels}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_SKY, lights}, {BLOCK_PASS, &pass->params}},
    };
    struct environment_lighting_params params = params_of(&pass->desc, frame);
    buffer_write(&pass->params, 0, sizeof params, &params);
    frame_add_medium(frame, &state);
    return state;
}

void environment_lighting_pass_render_lobes(const struct environment_lighting_pass *pass,
                                            const struct frame *frame,
                                            const struct gbuffer *gbuffer,
                                            const struct buffer *lights) {
    struct pass_state state = begin_view(pass, frame, gbuffer, lights);
    state.name = "sky in lobes";
    state.program = pass->lobe_program;
    state.framebuffer = pass->lobes.framebuffer;
    state.width = pass->desc.width;
    state.height = pass->desc.height;
    pass_add_texture(&state, UNIT_GBUFFER_SPECULAR, gbuffer->specular.id);
    pass_add_texture(&state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
    pass_add_texture(&state, UNIT_LOBE_SKY, frame->scene->sky.id);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

void environment_lighting_pass_render(const struct environment_lighting_pass *pass,
                                      const struct frame *frame, const struct gbuffer *gbuffer,
                                      const struct environment_lighting_inputs *inputs) {
    struct pass_state state = begin_view(pass, frame, gbuffer, inputs->lights);
    pass_add_texture(&state, UNIT_SKY_SHARES, pass->shares.id);
    draw_blocks(pass, frame, &state);
    pass_add_texture(&state, UNIT_BLOCK_VISIBILITY, pass->blocks.id);
    pass_add_texture(&state, UNIT_DIRECT, inputs->direct->id);
    if (pass->desc.specular) {
        pass_add_texture(&state, UNIT_GBUFFER_SPECULAR, gbuffer->specular.id);
        pass_add_texture(&state, UNIT_LOBES, frame->scene->lobes.id);
        pass_add_texture(&state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
        pass_add_texture(&state, UNIT_DIRECT_SPECULAR, inputs->specular->id);
        pass_add_texture(&state, UNIT_SKY_REFLECTED, inputs->reflected->id);
    }
    draw_light(pass, frame, &state);
}
