#include "passes/visibility/block_visibility.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/maps.h"

#include <stdlib.h>

static bool init_program(struct block_visibility_pass *pass) {
    char *defines = visibility_defines(&pass->desc.visibility);
    bool ok = program_init(
        &pass->program, &(struct program_desc){
                            .screen = {"passes/visibility/block_visibility.frag", .layers = true},
                            .defines = defines});
    free(defines);
    return ok;
}

static bool init_target(struct block_visibility_pass *pass) {
    const struct block_visibility_desc *desc = &pass->desc;
    return framebuffer_init_target(&pass->blocks.texture, &pass->blocks.framebuffer,
                                   &(struct texture_desc){
                                       .label = "block visibility",
                                       .target = GL_TEXTURE_2D_ARRAY,
                                       .format = GL_R8,
                                       .width = (desc->width + desc->block - 1) / desc->block,
                                       .height = (desc->height + desc->block - 1) / desc->block,
                                       .layers = desc->visibility.map_count,
                                   });
}

bool block_visibility_pass_init(struct block_visibility_pass *pass,
                                const struct block_visibility_desc *desc) {
    *pass = (struct block_visibility_pass){.desc = *desc, .blocks.block = desc->block};
    struct block_visibility_params params = {.block = desc->block};
    if (init_program(pass) && init_target(pass) &&
        buffer_init(&pass->params, "block parameters", sizeof params, &params) &&
        buffer_init(&pass->lookup_params, "lookup parameters", sizeof(struct lookup_params), NULL))
        return true;
    block_visibility_pass_free(pass);
    return false;
}

void block_visibility_pass_free(struct block_visibility_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->blocks.framebuffer);
    texture_free(&pass->blocks.texture);
    buffers_free(&pass->params, &pass->lookup_params);
    *pass = (struct block_visibility_pass){0};
}

void block_visibility_pass_render(const struct block_visibility_pass *pass,
                                  const struct frame *frame, const struct gbuffer *gbuffer,
                                  const struct visibility_inputs *inputs) {
    const struct texture *target = &pass->blocks.texture;
    struct pass_state state = {
        .name = "block visibility",
        .program = pass->program,
        .framebuffer = pass->blocks.framebuffer,
        .width = target->desc.width,
        .height = target->desc.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
    visibility_add(&state, &pass->desc.visibility, &pass->lookup_params, inputs);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(pass->desc.visibility.map_count);
    pass_end(frame->timers);
}
