#include "passes/volume/distance.h"

#include "base/memory.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/volumes.h"

#include <stdlib.h>

bool distance_pass_init(struct distance_pass *pass, const struct volume *volume) {
    *pass = (struct distance_pass){0};
    char *own = volume_defines(volume);
    char *counting = mem_printf("%s;COUNT", own);
    bool ok = program_init(
        &pass->neighbour_program,
        &(struct program_desc){.screen = {"passes/volume/smooth.frag"}, .defines = counting});
    free(counting);
    for (int axis = 0; ok && axis < 3; axis++) {
        char *defines = mem_printf("%s;AXIS %d", own, axis);
        ok = program_init(
            &pass->programs[axis],
            &(struct program_desc){.screen = {"passes/volume/distance.frag"}, .defines = defines});
        free(defines);
    }
    free(own);
    if (!ok)
        distance_pass_free(pass);
    return ok;
}

void distance_pass_free(struct distance_pass *pass) {
    for (int axis = 0; axis < 3; axis++)
        program_free(&pass->programs[axis]);
    program_free(&pass->neighbour_program);
}

/* From one of the two textures to the other. */
static void draw_step(const struct frame *frame, const struct volume *volume,
                      const struct buffer *params, GLuint program, int target) {
    struct pass_state state = {
        .name = "distances",
        .program = program,
        .framebuffer = volume->distance_framebuffers[target],
        .width = volume->grid.width,
        .height = volume->grid.height,
        .textures = {{UNIT_VOLUME_SURFACES, volume->surfaces.id},
                     {UNIT_VOLUME_DISTANCES, volume->distances[1 - target].id}},
        .blocks = {{BLOCK_PASS, params}},
    };
    if (volume->desc.medium)
        frame_add_medium(frame, &state);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

void distance_pass_render(const struct distance_pass *pass, const struct frame *frame,
                          const struct volume *volume, const struct buffer *params) {
    timer_begin(frame->timers, "distances");
    for (int axis = 0; axis < 3; axis++)
        draw_step(frame, volume, params, pass->programs[axis], axis % 2);
    draw_step(frame, volume, params, pass->neighbour_program, 1);
    timer_end(frame->timers);
}
