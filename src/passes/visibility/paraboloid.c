#include "passes/visibility/paraboloid.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/maps.h"

#include <stdlib.h>

/* Simplified casters come before what they stand for by up to their error, and would shadow it:
 * maps have them farther off by this much of the error. */
static const float set_back = .25F;

static bool is_long(enum caster_kind kind) {
    return kind == CASTER_LONG || kind == CASTER_LONG_SOLID;
}

static bool is_solid(enum caster_kind kind) {
    return kind == CASTER_SHORT_SOLID || kind == CASTER_LONG_SOLID;
}

static bool init_program(GLuint *program, enum caster_kind kind, const char *defines) {
    char *own = mem_printf("%s%s%s", defines, is_long(kind) ? ";LONG" : "",
                           kind == CASTER_LONG_SOLID ? ";SOLID" : "");
    bool ok = program_init(
        program, &(struct program_desc){
                     .vertex = is_long(kind) ? "passes/visibility/paraboloid_long.vert"
                                             : "passes/visibility/paraboloid.vert",
                     .geometry = is_long(kind) ? "passes/visibility/paraboloid_long.geom" : NULL,
                     .fragment = "passes/visibility/paraboloid.frag",
                     .defines = own,
                 });
    free(own);
    return ok;
}

static bool init_programs(struct paraboloid_pass *pass) {
    const char *opaque = pass->desc.planes ? "PLANES 1" : "PLANES 0";
    const char *masked = pass->desc.planes ? "PLANES 1;MASKED" : "PLANES 0;MASKED";
    bool ok = true;
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        ok = ok && init_program(&pass->opaque_programs[l], (enum caster_kind)l, opaque);
    for (int l = 0; l <= CASTER_LONG; l++)
        ok = ok && init_program(&pass->masked_programs[l], (enum caster_kind)l, masked);
    return ok;
}

bool paraboloid_pass_init(struct paraboloid_pass *pass, const struct paraboloid_desc *desc) {
    *pass = (struct paraboloid_pass){.desc = *desc};
    if (caster_pool_acquire(desc->casters, &pass->caster, &desc->caster) && init_programs(pass) &&
        depth_maps_init(&pass->maps, &(struct depth_maps_desc){"paraboloid", desc->size,
                                                               desc->count, desc->planes}) &&
        buffer_init(&pass->params, "map parameters", sizeof(struct paraboloid_params), NULL))
        return true;
    paraboloid_pass_free(pass);
    return false;
}

void paraboloid_pass_free(struct paraboloid_pass *pass) {
    caster_pool_release(pass->desc.casters, &pass->caster);
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        program_free(&pass->opaque_programs[l]);
    for (int l = 0; l <= CASTER_LONG; l++)
        program_free(&pass->masked_programs[l]);
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
                         enum caster_kind kind, const struct scene_gpu *scene, int count) {
    struct caster_draw draw = {kind, count};
    state->clip_distances = is_long(kind) ? 0 : 2;
    /* Directions go to the right, up and away from the eye, and so are the other way around in the
     * map. */
    state->cull = kind == CASTER_SHORT_SOLID ? PASS_CULL_FRONT : PASS_CULL_NONE;
    state->program = pass->opaque_programs[kind];
    pass_set_state(state);
    caster_gpu_draw_opaque(pass->caster, &draw);
    if (is_solid(kind) || !caster_gpu_has_masked(pass->caster))
        return;
    state->program = pass->masked_programs[kind];
    pass_set_state(state);
    caster_gpu_draw_masked(pass->caster, scene, &draw);
}

void paraboloid_pass_render(const struct paraboloid_pass *pass, const struct frame *frame,
                            const struct map_views *views) {
    struct pass_state state = {
        .name = "depth maps",
        .program = pass->opaque_programs[CASTER_SHORT],
        .framebuffer = pass->maps.framebuffer,
        .vertex_array = caster_gpu_vertices(pass->caster, frame->scene),
        .width = pass->maps.size,
        .height = pass->maps.size,
        .depth = PASS_DEPTH_LESS,
        .blocks = {{BLOCK_MAPS, &views->buffer}, {BLOCK_PASS, &pass->params}},
    };
    write_params(pass);
    pass_begin(frame->timers, &state);
    framebuffer_clear_depth(pass->maps.framebuffer, 1);
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        draw_casters(pass, &state, (enum caster_kind)l, frame->scene, views->count);
    pass_end(frame->timers);
}
