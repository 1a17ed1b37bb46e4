#include "passes/volume/march.h"

#include "base/memory.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/volumes.h"

#include <stdlib.h>

/* Drawn: more targets than a dispatch stores to. */
bool march_pass_init(struct march_pass *pass, const struct volume *volume) {
    char *defines = volume_defines(volume);
    *pass = (struct march_pass){0};
    bool ok =
        program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                            .fragment = "passes/volume/march.frag",
                                                            .defines = defines});
    ok = ok && program_init(&pass->smooth_program,
                            &(struct program_desc){.screen = {"passes/volume/smooth.frag"},
                                                   .defines = defines});
    mem_free(defines);
    if (!ok)
        march_pass_free(pass);
    return ok;
}

void march_pass_free(struct march_pass *pass) {
    programs_free(&pass->program, &pass->smooth_program);
    *pass = (struct march_pass){0};
}

static void smooth(const struct march_pass *pass, const struct frame *frame,
                   const struct volume *volume, const struct buffer *params) {
    timer_begin(frame->timers, "smooth");
    for (int i = 0; i < volume->coefficient_count; i++) {
        pass_set_state(&(struct pass_state){
            .name = "smooth",
            .program = pass->smooth_program,
            .framebuffer = volume->smooth_framebuffers[i],
            .width = volume->grid.width,
            .height = volume->grid.height,
            .textures = {{UNIT_VOLUME_DISTANCES, volume->distances[0].id},
                         {UNIT_VOLUME_NEIGHBOURS, volume->distances[1].id},
                         {UNIT_VOLUME_COEFFICIENTS, volume->coefficients[i + 1].id}},
            .blocks = {{BLOCK_PASS, params}},
        });
        pass_draw_fullscreen(1);
    }
    timer_end(frame->timers);
}

void march_pass_render(const struct march_pass *pass, const struct frame *frame,
                       const struct volume *volume, const struct buffer *params,
                       const struct march_inputs *inputs) {
    struct pass_state state = {
        .name = "march",
        .program = pass->program,
        .framebuffer = volume->march_framebuffer,
        .width = volume->grid.width,
        .height = volume->grid.height,
        .textures = {{UNIT_VOLUME_DISTANCES, volume->distances[0].id}},
        .blocks = {{BLOCK_PASS, params}},
    };
    if (volume->desc.medium)
        frame_add_medium(frame, &state);
    if (volume->desc.channels == VOLUME_RADIANCE) {
        pass_add_texture(&state, UNIT_VOLUME_SURFACES, volume->surfaces.id);
        pass_add_texture(&state, UNIT_VOLUME_RADIOSITY, inputs->radiosity->id);
        if (volume->desc.both_sides)
            pass_add_texture(&state, UNIT_VOLUME_BACK, inputs->back->id);
        if (volume_is_split(&volume->desc)) {
            pass_add_texture(&state, UNIT_VOLUME_TURNED_SURFACES, volume->turned_surfaces.id);
            pass_add_texture(&state, UNIT_VOLUME_TURNED_RADIOSITY, inputs->turned_radiosity->id);
        }
    }
    pass_begin(frame->timers, &state);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
    smooth(pass, frame, volume, params);
}
