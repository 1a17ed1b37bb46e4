#include "passes/volume/inject.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/volumes.h"

#include <stdlib.h>

bool inject_pass_init(struct inject_pass *pass, const struct volume *volume) {
    bool lit = volume->desc.channels == VOLUME_RADIANCE;
    char *own = volume_defines(volume);
    char *defines = mem_printf("%s;POINT_LIGHT volume/point_%s.glsl", own, lit ? "lit" : "unlit");
    bool ok = program_init(&pass->program, &(struct program_desc){.vertex = "volume/inject.vert",
                                                                  .fragment = "volume/inject.frag",
                                                                  .defines = defines});
    free(own);
    free(defines);
    return ok;
}

void inject_pass_free(struct inject_pass *pass) {
    program_free(&pass->program);
    *pass = (struct inject_pass){0};
}

static void clear(const struct volume *volume) {
    static const float none[4] = {0};
    int targets = volume->desc.channels == VOLUME_RADIANCE
                      ? 2 + volume->desc.both_sides + volume->desc.bounces
                      : 1;
    for (int i = 0; i < targets; i++)
        framebuffer_clear_color(volume->points_framebuffer, i, none);
}

void inject_pass_render(const struct inject_pass *pass, const struct frame *frame,
                        const struct volume *volume, const struct buffer *params,
                        const struct volume_points *points, const struct texture *shadow_maps) {
    struct pass_state state = {
        .name = "inject",
        .program = pass->program,
        .framebuffer = volume->points_framebuffer,
        .vertex_array = points->vertices,
        .width = volume->grid.width,
        .height = volume->grid.height,
        .blend = PASS_BLEND_ADD,
        .blocks = {{BLOCK_PASS, params}},
    };
    if (shadow_maps) {
        pass_add_block(&state, BLOCK_LIGHTS, frame->lights);
        for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
            bool has = shadow_maps[kind].id;
            pass_add_texture(&state, UNIT_VOLUME_SHADOWS + (GLuint)kind,
                             shadow_maps[has ? kind : !kind].id);
        }
    }
    pass_begin(frame->timers, &state);
    clear(volume);
    pass_draw(GL_POINTS, points->points.count, 1);
    pass_end(frame->timers);
}
