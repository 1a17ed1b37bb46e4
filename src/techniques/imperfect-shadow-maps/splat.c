#include "techniques/imperfect-shadow-maps/splat.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/splat.h"

static bool init_program(struct splat_pass *pass) {
    char *defines = mem_printf("SPLAT %d", pass->desc.shape);
    bool ok = program_init(
        &pass->program,
        &(struct program_desc){.vertex = "techniques/imperfect-shadow-maps/splat.vert",
                               .fragment = "techniques/imperfect-shadow-maps/splat.frag",
                               .defines = defines});
    free(defines);
    return ok;
}

bool splat_pass_init(struct splat_pass *pass, const struct splat_desc *desc) {
    *pass = (struct splat_pass){.desc = *desc};
    if (init_program(pass) &&
        depth_maps_init(&pass->maps, &(struct depth_maps_desc){"imperfect", desc->size, desc->count,
                                                               desc->shape == SPLAT_DISK}) &&
        caster_points_init(&pass->points, &desc->points) &&
        buffer_init(&pass->params, "splat parameters", sizeof(struct splat_params), NULL))
        return true;
    splat_pass_free(pass);
    return false;
}

void splat_pass_free(struct splat_pass *pass) {
    caster_points_free(&pass->points);
    program_free(&pass->program);
    depth_maps_free(&pass->maps);
    buffer_free(&pass->params);
    *pass = (struct splat_pass){0};
}

void splat_pass_render(struct splat_pass *pass, const struct frame *frame,
                       const struct map_views *views, int first) {
    const struct splat_desc *desc = &pass->desc;
    struct splat_params params = {
        .first = first,
        .points = desc->points.count,
        .sets = desc->points.sets,
        .map_size = (float)desc->size,
        .scale = desc->scale,
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
    caster_points_place(&pass->points, frame->geometry);
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "depth maps",
                   .program = pass->program,
                   .framebuffer = pass->maps.framebuffer,
                   .width = desc->size,
                   .height = desc->size,
                   .depth = PASS_DEPTH_LESS,
                   .point_size = true,
                   .textures = {{UNIT_CASTER_POINTS, pass->points.buffer.texels}},
                   .blocks = {{BLOCK_MAPS, &views->buffer}, {BLOCK_PASS, &pass->params}},
               });
    framebuffer_clear_depth(pass->maps.framebuffer, 1);
    pass_draw(GL_POINTS, desc->points.count, views->count);
    pass_end(frame->timers);
}
