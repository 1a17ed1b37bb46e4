#include "passes/volume/distance.h"

#include "base/memory.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/volumes.h"

#include <stdlib.h>

bool distance_pass_init(struct distance_pass *pass) {
    *pass = (struct distance_pass){0};
    bool ok = true;
    for (int axis = 0; ok && axis < 3; axis++) {
        char *defines = mem_printf("AXIS %d", axis);
        ok = program_init(
            &pass->programs[axis],
            &(struct program_desc){.screen = {"volume/distance.frag"}, .defines = defines});
        free(defines);
    }
    if (!ok)
        distance_pass_free(pass);
    return ok;
}

void distance_pass_free(struct distance_pass *pass) {
    for (int axis = 0; axis < 3; axis++)
        program_free(&pass->programs[axis]);
}

void distance_pass_render(const struct distance_pass *pass, const struct frame *frame,
                          const struct volume *volume, const struct buffer *params) {
    timer_begin(frame->timers, "distances");
    for (int axis = 0; axis < 3; axis++) {
        const struct texture *source =
            axis == 0 ? &volume->surfaces : &volume->distances[(axis + 1) % 2];
        pass_set_state(&(struct pass_state){
            .name = "distances",
            .program = pass->programs[axis],
            .framebuffer = volume->distance_framebuffers[axis % 2],
            .width = volume->grid.width,
            .height = volume->grid.height,
            .textures = {{axis == 0 ? UNIT_VOLUME_SURFACES : UNIT_VOLUME_DISTANCES, source->id}},
            .blocks = {{BLOCK_PASS, params}},
        });
        pass_draw_fullscreen(1);
    }
    timer_end(frame->timers);
}
