#include "passes/visibility/light_map.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"

#include <stdlib.h>

static bool init_program(struct light_map_pass *pass) {
    char *defines = mem_printf("MAP_SIZE %d", pass->maps.size);
    bool ok = program_init(
        &pass->program,
        &(struct program_desc){.screen = {"passes/visibility/light_map.frag", .layers = true},
                               .defines = defines});
    free(defines);
    return ok;
}

bool light_map_pass_init(struct light_map_pass *pass, int size, const struct light_layout *lights) {
    *pass = (struct light_map_pass){.maps = {.size = size, .count = lights->maps}};
    if (init_program(pass) &&
        framebuffer_init_target(&pass->maps.depth, &pass->framebuffer,
                                &(struct texture_desc){.label = "light maps",
                                                       .target = GL_TEXTURE_2D_ARRAY,
                                                       .format = GL_R32F,
                                                       .width = size,
                                                       .height = size,
                                                       .layers = lights->maps}))
        return true;
    light_map_pass_free(pass);
    return false;
}

void light_map_pass_free(struct light_map_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->maps.depth);
    *pass = (struct light_map_pass){0};
}

void light_map_pass_render(const struct light_map_pass *pass, const struct frame *frame,
                           const struct texture views[LIGHT_MAP_KINDS]) {
    const struct light_block *block = frame->light_block;
    struct pass_state state = {
        .name = "light maps",
        .program = pass->program,
        .framebuffer = pass->framebuffer,
        .width = pass->maps.size,
        .height = pass->maps.size,
        .blocks = {{BLOCK_LIGHTS, frame->lights}},
    };
    timer_begin(frame->timers, state.name);
    for (int i = 0; i < block->count; i++) {
        const struct light *light = &block->sources[i];
        int kind = block->views[light->first_view].kind;
        state.textures[0] = (struct pass_texture){UNIT_MAP_DEPTH, views[kind].id};
        pass_set_state(&state);
        gl.ProgramUniform1i(pass->program, LOCATION_LIGHT, i);
        gl.ProgramUniform1i(pass->program, LOCATION_FIRST_LAYER, light->first_map);
        pass_draw_fullscreen(light->type == LIGHT_TYPE_POINT ? 6 : 1);
    }
    timer_end(frame->timers);
}
