#include "passes/visibility/paraboloid.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/paraboloid.h"

#include <stdlib.h>

/* Simplified casters come before what they stand for by up to their error, and would shadow it: maps
 * have them farther off by this much of the error. */
static const float set_back = .5F;

static bool init_pair(GLuint programs[2], bool masked, bool planes) {
    char *defines = mem_printf("PLANES %d%s", planes, masked ? ";MASKED" : "");
    char *long_defines = mem_printf("LONG;%s", defines);
    bool ok = program_init(&programs[CASTER_SHORT],
                           &(struct program_desc){.vertex = "visibility/paraboloid.vert",
                                                  .fragment = "visibility/paraboloid.frag",
                                                  .defines = defines}) &&
              program_init(&programs[CASTER_LONG],
                           &(struct program_desc){.vertex = "visibility/paraboloid_long.vert",
                                                  .geometry = "visibility/paraboloid_long.geom",
                                                  .fragment = "visibility/paraboloid.frag",
                                                  .defines = long_defines});
    free(defines);
    free(long_defines);
    return ok;
}

bool paraboloid_pass_init(struct paraboloid_pass *pass, const struct paraboloid_desc *desc) {
    *pass = (struct paraboloid_pass){.desc = *desc};
    if (caster_pool_acquire(desc->casters, &pass->caster, &desc->caster) &&
        init_pair(pass->opaque_programs, false, desc->planes) &&
        init_pair(pass->masked_programs, true, desc->planes) &&
        depth_maps_init(&pass->maps, &(struct depth_maps_desc){"paraboloid", desc->size,
                                                               desc->count, desc->planes}) &&
        buffer_init(&pass->params, "map parameters", sizeof(struct paraboloid_params), NULL))
        return true;
    paraboloid_pass_free(pass);
    return false;
}

void paraboloid_pass_free(struct paraboloid_pass *pass) {
    caster_pool_release(pass->desc.casters, &pass->caster);
    for (int l = 0; l < 2; l++) {
        program_free(&pass->opaque_programs[l]);
        program_free(&pass->masked_programs[l]);
    }
    depth_maps_free(&pass->maps);
    buffer_free(&pass->params);
    *pass = (struct paraboloid_pass){0};
}

static void write_params(const struct paraboloid_pass *pass) {
    struct paraboloid_params params = {
        .texel = 2 / (float)pass->maps.size,
        .long_edge = pass->caster->caster.long_edge,
        .set_back = set_back * pass->caster->caster.error,
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
}

static void draw_casters(const struct paraboloid_pass *pass, struct pass_state *state,
                         enum caster_length length, const struct scene_gpu *scene, int count) {
    struct caster_draw draw = {length, count};
    state->clip_distances = length == CASTER_SHORT ? 2 : 0;
    state->program = pass->opaque_programs[length];
    pass_set_state(state);
    caster_gpu_draw_opaque(pass->caster, &draw);
    if (!caster_gpu_has_masked(pass->caster))
        return;
    state->program = pass->masked_programs[length];
    pass_set_state(state);
    caster_gpu_draw_masked(pass->caster, scene, &draw);
}

void paraboloid_pass_render(const struct paraboloid_pass *pass, const struct frame *frame,
                            const struct map_views *views) {
    struct pass_state state = {
        .name = "depth maps",
        .program = pass->opaque_programs[CASTER_SHORT],
        .framebuffer = pass->maps.framebuffer,
        .vertex_array = pass->caster->vertices,
        .width = pass->maps.size,
        .height = pass->maps.size,
        .depth = PASS_DEPTH_LESS,
        .blocks = {{BLOCK_MAPS, &views->buffer}, {BLOCK_PASS, &pass->params}},
    };
    write_params(pass);
    pass_begin(frame->timers, &state);
    framebuffer_clear_depth(pass->maps.framebuffer, 1);
    for (int l = 0; l < 2; l++)
        draw_casters(pass, &state, (enum caster_length)l, frame->scene, views->count);
    pass_end(frame->timers);
}
