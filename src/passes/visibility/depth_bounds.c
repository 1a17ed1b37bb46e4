#include "passes/visibility/depth_bounds.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/maps.h"

static bool init_params(struct depth_bounds_pass *pass) {
    for (int level = 0; level < pass->maps.levels; level++) {
        struct depth_bounds_params params = {
            .level = level, .base = pass->maps.size / 2, .map_size = pass->maps.size};
        if (!buffer_init(&pass->params[level], "depth bounds", sizeof params, &params))
            return false;
    }
    return true;
}

bool depth_bounds_pass_init(struct depth_bounds_pass *pass, int size, int count) {
    int base = size / 2;
    *pass = (struct depth_bounds_pass){
        .maps = {.size = size, .count = count, .levels = texture_full_levels(base, base)}};
    if (program_init(&pass->first_program,
                     &(struct program_desc){.compute = "passes/visibility/depth_bounds.comp",
                                            .defines = "FIRST"}) &&
        program_init(&pass->more_program,
                     &(struct program_desc){.compute = "passes/visibility/depth_bounds.comp"}) &&
        texture_init(&pass->maps.bounds,
                     &(struct texture_desc){
                         .label = "depth bounds",
                         .target = GL_TEXTURE_2D_ARRAY,
                         .format = GL_RG32F,
                         .width = base + base / 2,
                         .height = base,
                         .layers = count,
                     }) &&
        init_params(pass))
        return true;
    depth_bounds_pass_free(pass);
    return false;
}

void depth_bounds_pass_free(struct depth_bounds_pass *pass) {
    programs_free(&pass->first_program, &pass->more_program);
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
        .textures = {{UNIT_MAP_DEPTH, depth->id}},
        .images = {{IMAGE_DEPTH_BOUNDS, &pass->maps.bounds, 0, GL_READ_WRITE}},
    };
    timer_begin(frame->timers, state.name);
    for (int level = 0; level < pass->maps.levels; level++) {
        int groups = (bounds_side(pass->maps.size / 2, level) + BOUNDS_GROUP - 1) / BOUNDS_GROUP;
        state.blocks[0] = (struct pass_block){.block = BLOCK_PASS, .buffer = &pass->params[level]};
        pass_set_state(&state);
        pass_dispatch(groups, groups, pass->maps.count);
        state.program = pass->more_program;
        state.barriers = GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    }
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    timer_end(frame->timers);
}
