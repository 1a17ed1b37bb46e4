#include "passes/visibility/sky_map.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/bindings.h"

#include <stdlib.h>

/* Simplified casters come before what they stand for by up to their error, and would shadow it: maps
 * have them farther off by this much of the error. */
static const float set_back = .5F;

static bool init_programs(struct sky_map_pass *pass) {
    char *defines = sky_map_defines(&pass->desc.layout);
    char *masked_defines = mem_printf("%s;MASKED", defines);
    bool ok = program_init(&pass->opaque_program,
                           &(struct program_desc){.vertex = "visibility/sky_map.vert",
                                                  .fragment = "picture/depth_only.frag",
                                                  .defines = defines}) &&
              program_init(&pass->masked_program,
                           &(struct program_desc){.vertex = "visibility/sky_map.vert",
                                                  .fragment = "visibility/sky_map.frag",
                                                  .defines = masked_defines});
    free(defines);
    free(masked_defines);
    return ok;
}

bool sky_map_pass_init(struct sky_map_pass *pass, const struct sky_map_desc *desc) {
    *pass = (struct sky_map_pass){.desc = *desc};
    if (caster_pool_acquire(desc->casters, &pass->caster, &desc->caster) && init_programs(pass) &&
        texture_init(&pass->maps,
                     &(struct texture_desc){.label = "sky maps",
                                            .target = GL_TEXTURE_2D_ARRAY,
                                            .format = GL_DEPTH_COMPONENT16,
                                            .width = desc->layout.size,
                                            .height = desc->layout.size,
                                            .layers = sky_map_layers(&desc->layout)}) &&
        framebuffer_init(&pass->framebuffer,
                         &(struct framebuffer_desc){.label = "sky maps", .depth = &pass->maps}))
        return true;
    sky_map_pass_free(pass);
    return false;
}

void sky_map_pass_free(struct sky_map_pass *pass) {
    caster_pool_release(pass->desc.casters, &pass->caster);
    program_free(&pass->opaque_program);
    program_free(&pass->masked_program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->maps);
    *pass = (struct sky_map_pass){0};
}

static void begin(const struct sky_map_pass *pass, struct pass_state *state, GLuint program) {
    state->program = program;
    pass_set_state(state);
    gl.ProgramUniform1f(program, LOCATION_SET_BACK, set_back * pass->caster->caster.error);
}

void sky_map_pass_render(const struct sky_map_pass *pass, const struct frame *frame,
                         const struct buffer *lights) {
    struct pass_state state = {
        .name = "sky maps",
        .program = pass->opaque_program,
        .framebuffer = pass->framebuffer,
        .vertex_array = pass->caster->vertices,
        .width = pass->desc.layout.size,
        .height = pass->desc.layout.size,
        .depth = PASS_DEPTH_LESS,
        .blocks = {{BLOCK_SKY, lights}},
    };
    int count = sky_map_layers(&pass->desc.layout);
    pass_begin(frame->timers, &state);
    framebuffer_clear_depth(pass->framebuffer, 1);
    begin(pass, &state, pass->opaque_program);
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        caster_gpu_draw_opaque(pass->caster, &(struct caster_draw){(enum caster_kind)l, count});
    if (caster_gpu_has_masked(pass->caster)) {
        begin(pass, &state, pass->masked_program);
        for (int l = 0; l <= CASTER_LONG; l++)
            caster_gpu_draw_masked(pass->caster, frame->scene,
                                   &(struct caster_draw){(enum caster_kind)l, count});
    }
    pass_end(frame->timers);
}
