#include "passes/visibility/direct_light.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/maps.h"

#include <stdlib.h>

static bool init_light(struct texture *texture, const char *label, int width, int height) {
    return texture_init(
        texture, &(struct texture_desc){
                     .label = label, .format = GL_RGBA32F, .width = width, .height = height});
}

static bool init_target(struct direct_light_target *target, bool specular, int width, int height) {
    *target = (struct direct_light_target){0};
    struct framebuffer_desc desc = {.label = "direct", .colors = {&target->light}};
    if (specular)
        desc.colors[TARGET_DIRECT_SPECULAR] = &target->specular;
    return init_light(&target->light, "direct", width, height) &&
           (!specular || init_light(&target->specular, "direct specular", width, height)) &&
           framebuffer_init(&target->framebuffer, &desc);
}

static void free_target(struct direct_light_target *target) {
    framebuffer_free(&target->framebuffer);
    textures_free(&target->light, &target->specular);
}

static bool init_program(GLuint *program, const struct direct_light_desc *desc, int projection) {
    char *defines =
        mem_printf("%s%s%sPROJECTION %d", desc->defines, desc->specular ? "HAS_SPECULAR;" : "",
                   light_defines(desc->medium, desc->slides),
                   desc->own_maps ? PROJECTION_LIGHT_MAP : projection);
    bool ok =
        program_init(program, &(struct program_desc){.screen = {desc->fragment, .blended = true},
                                                     .defines = defines});
    free(defines);
    return ok;
}

static bool init_lookups(struct direct_light_pass *pass, const struct direct_light_desc *desc) {
    bool ok = true;
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        int size = desc->own_maps ? desc->map_size : light_map_size(kind, desc->map_size);
        struct lookup_params params = {.bias = desc->bias,
                                       .map_bias = desc->map_bias,
                                       .map_size = (float)size,
                                       .contact = desc->contact,
                                       .shift = desc->shift,
                                       .gain = desc->gain};
        ok = ok && buffer_init(&pass->lookups[kind], "direct lookup", sizeof params, &params);
    }
    return ok;
}

bool direct_light_pass_init(struct direct_light_pass *pass, const struct direct_light_desc *desc) {
    *pass = (struct direct_light_pass){0};
    bool ok = init_program(&pass->perspective_program, desc, PROJECTION_PERSPECTIVE) &&
              init_program(&pass->orthographic_program, desc, PROJECTION_ORTHOGRAPHIC) &&
              init_target(&pass->target, desc->specular, desc->width, desc->height) &&
              init_lookups(pass, desc);
    if (!ok)
        direct_light_pass_free(pass);
    return ok;
}

void direct_light_pass_free(struct direct_light_pass *pass) {
    programs_free(&pass->perspective_program, &pass->orthographic_program);
    free_target(&pass->target);
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        buffer_free(&pass->lookups[kind]);
    *pass = (struct direct_light_pass){0};
}

bool direct_light_pass_resize(struct direct_light_pass *pass, int width, int height) {
    struct direct_light_target target;
    bool ok = init_target(&target, pass->target.specular.id, width, height);
    free_target(ok ? &pass->target : &target);
    if (ok)
        pass->target = target;
    return ok;
}

static void draw_light(const struct direct_light_pass *pass, const struct frame *frame,
                       const struct gbuffer *gbuffer, const struct direct_light_inputs *inputs,
                       int index, bool adds) {
    const struct light *light = &frame->light_block->sources[index];
    int kind = frame->light_block->views[light->first_view].kind;
    bool directional = light->type == LIGHT_TYPE_DIRECTIONAL;
    GLuint program = directional ? pass->orthographic_program : pass->perspective_program;
    struct pass_state state = {
        .name = "direct",
        .program = program,
        .framebuffer = pass->target.framebuffer,
        .width = pass->target.light.desc.width,
        .height = pass->target.light.desc.height,
        .blend = adds ? PASS_BLEND_ADD : PASS_BLEND_OFF,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_MAP_DEPTH, inputs->maps[kind]->id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_LOOKUP, &pass->lookups[kind]}},
    };
    for (int i = 0; i < DIRECT_LIGHT_TEXTURES_MAX && inputs->more[i].texture; i++)
        pass_add_texture(&state, inputs->more[i].unit, inputs->more[i].texture);
    if (pass->target.specular.id) {
        pass_add_texture(&state, UNIT_GBUFFER_SPECULAR, gbuffer->specular.id);
        pass_add_texture(&state, UNIT_LOBES, frame->scene->lobes.id);
        pass_add_texture(&state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
    }
    frame_add_light(frame, &state);
    if (inputs->block.buffer)
        pass_add_block(&state, inputs->block.block, inputs->block.buffer);
    pass_set_state(&state);
    gl.ProgramUniform1i(program, LOCATION_LIGHT, index);
    pass_draw_fullscreen(1);
}

void direct_light_pass_render(const struct direct_light_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer,
                              const struct direct_light_inputs *inputs,
                              enum direct_light_start start) {
    static const float none[4] = {0};
    timer_begin(frame->timers, "direct");
    if (frame->light_block->count == 0 && start == DIRECT_LIGHT_ANEW) {
        framebuffer_clear_color(pass->target.framebuffer, TARGET_RESULT, none);
        if (pass->target.specular.id)
            framebuffer_clear_color(pass->target.framebuffer, TARGET_DIRECT_SPECULAR, none);
    }
    for (int i = 0; i < frame->light_block->count; i++)
        draw_light(pass, frame, gbuffer, inputs, i, i > 0 || start == DIRECT_LIGHT_ADDS);
    timer_end(frame->timers);
}
