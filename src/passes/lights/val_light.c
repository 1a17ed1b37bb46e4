#include "passes/lights/val_light.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/maps.h"

#include <stdlib.h>

bool val_light_pass_init(struct val_light_pass *pass, const struct visibility_desc *desc) {
    *pass = (struct val_light_pass){.desc = *desc};
    char *defines = visibility_defines(desc);
    bool ok =
        program_init(&pass->program,
                     &(struct program_desc){.screen = {"passes/lights/val_light.frag"},
                                            .defines = defines}) &&
        buffer_init(&pass->lookup_params, "lookup parameters", sizeof(struct lookup_params), NULL);
    free(defines);
    if (!ok)
        val_light_pass_free(pass);
    return ok;
}

void val_light_pass_free(struct val_light_pass *pass) {
    program_free(&pass->program);
    buffer_free(&pass->lookup_params);
    *pass = (struct val_light_pass){0};
}

void val_light_pass_render(const struct val_light_pass *pass, const struct frame *frame,
                           const struct gbuffer *gbuffer, const struct visibility_inputs *inputs,
                           const struct texture *val_fluxes, GLuint framebuffer) {
    struct pass_state state = {
        .name = "val light",
        .program = pass->program,
        .framebuffer = framebuffer,
        .width = gbuffer->width,
        .height = gbuffer->height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_VAL_FLUX, val_fluxes->id}},
        .blocks = {{BLOCK_VIEW, frame->view}},
    };
    visibility_add(&state, &pass->desc, &pass->lookup_params, inputs);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
