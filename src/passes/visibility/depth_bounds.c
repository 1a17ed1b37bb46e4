#include "passes/visibility/depth_bounds.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "shared/depth_bounds.h"

static bool init_params(struct depth_bounds_pass *pass) {
    int below = pass->maps.size;
    for (int level = 0; level < pass->maps.bounds.desc.levels; level++) {
        struct depth_bounds_params params = {
            .level = level, .size = below > 1 ? below / 2 : 1, .below = below};
        if (!buffer_init(&pass->params[level], "depth bounds", sizeof params, &params))
            return false;
        below = params.size;
    }
    return true;
}

bool depth_bounds_pass_init(struct depth_bounds_pass *pass, int size, int count) {
    *pass = (struct depth_bounds_pass){.maps = {.size = size, .count = count}};
    if (program_init(&pass->first_program,
                     &(struct program_desc){.compute = "visibility/depth_bounds.comp",
                                            .defines = "FIRST"}) &&
        program_init(&pass->more_program,
                     &(struct program_desc){.compute = "visibility/depth_bounds.comp"}) &&
        texture_init(&pass->maps.bounds,
                     &(struct texture_desc){
                         .label = "depth bounds",
                         .target = GL_TEXTURE_2D_ARRAY,
                         .format = GL_RG32F,
                         .width = size / 2,
                         .height = size / 2,
                         .layers = count,
                         .levels = texture_full_levels(size / 2, size / 2, 1),
                     }) &&
        init_params(pass))
        return true;
    depth_bounds_pass_free(pass);
    return false;
}

void depth_bounds_pass_free(struct depth_bounds_pass *pass) {
    program_free(&pass->first_program);
    program_free(&pass->more_program);
    texture_free(&pass->maps.bounds);
    for (int level = 0; level < DEPTH_BOUNDS_LEVELS_MAX; level++)
        buffer_free(&pass->params[level]);
    *pass = (struct depth_bounds_pass){0};
}

void depth_bounds_pass_render(const struct depth_bounds_pass *pass, const struct frame *frame,
                              const struct texture *depth) {
    struct pass_state state = {
        .name = "depth bounds",
        .program = pass->first_program,
        .textures = {{UNIT_MAP_DEPTH, depth->id}, {UNIT_DEPTH_BOUNDS, pass->maps.bounds.id}},
        .images = {{IMAGE_DEPTH_BOUNDS, &pass->maps.bounds, 0, GL_WRITE_ONLY}},
    };
    int size = pass->maps.size;
    timer_begin(frame->timers, state.name);
    for (int level = 0; level < pass->maps.bounds.desc.levels; level++) {
        size = size > 1 ? size / 2 : 1;
        state.images[0].level = level;
        state.blocks[0] = (struct pass_block){BLOCK_PASS, &pass->params[level], 0, 0};
        pass_set_state(&state);
        pass_dispatch((size + BOUNDS_GROUP - 1) / BOUNDS_GROUP,
                      (size + BOUNDS_GROUP - 1) / BOUNDS_GROUP, pass->maps.count);
        gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
        state.program = pass->more_program;
    }
    timer_end(frame->timers);
}
