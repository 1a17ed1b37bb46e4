#include "passes/volume/reconstruct.h"

#include "gl/program.h"
#include "passes/frame.h"
#include "passes/volumes.h"

#include <stdlib.h>

bool reconstruct_pass_init(struct reconstruct_pass *pass, const struct volume *volume, int width,
                           int height) {
    *pass = (struct reconstruct_pass){0};
    char *defines = volume_defines(volume);
    bool ok = program_init(&pass->program,
                           &(struct program_desc){.screen = {"passes/volume/reconstruct.frag"},
                                                  .defines = defines}) &&
              irradiance_init(&pass->irradiance, "irradiance of the volume", GL_RGBA16F, width,
                              height, 1);
    free(defines);
    if (!ok)
        reconstruct_pass_free(pass);
    return ok;
}

void reconstruct_pass_free(struct reconstruct_pass *pass) {
    program_free(&pass->program);
    irradiance_free(&pass->irradiance);
}

void reconstruct_pass_render(const struct reconstruct_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer, const struct volume *volume,
                             const struct buffer *params) {
    struct pass_state state = {
        .name = "reconstruct",
        .program = pass->program,
        .framebuffer = pass->irradiance.framebuffer,
        .width = pass->irradiance.width,
        .height = pass->irradiance.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_VOLUME_SURFACES, volume->surfaces.id},
                     {UNIT_VOLUME_DISTANCES, volume->distances[0].id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, params}},
    };
    if (volume_is_split(&volume->desc)) {
        pass_add_texture(&state, UNIT_VOLUME_RADIOSITY, volume->radiosity.id);
        pass_add_texture(&state, UNIT_VOLUME_TURNED_SURFACES, volume->turned_surfaces.id);
    }
    for (int i = 0; i < volume->coefficient_count; i++)
        pass_add_texture(&state, UNIT_VOLUME_COEFFICIENTS + (GLuint)i, volume->coefficients[i].id);
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
