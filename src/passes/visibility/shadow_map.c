#include "passes/visibility/shadow_map.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/bindings.h"

bool shadow_map_pass_init(struct shadow_map_pass *pass, const struct shadow_map_desc *desc) {
    int size = desc->light_views > 1 ? (desc->size + 1) / 2 : desc->size;
    *pass = (struct shadow_map_pass){0};
    if (program_init(&pass->opaque_program,
                     &(struct program_desc){.vertex = "visibility/shadow_map.vert",
                                            .fragment = "picture/depth_only.frag"}) &&
        program_init(&pass->masked_program,
                     &(struct program_desc){.vertex = "picture/geometry.vert",
                                            .fragment = "picture/geometry.frag",
                                            .defines = "LIGHT_VIEW;DEPTH_ONLY"}) &&
        texture_init(&pass->map, &(struct texture_desc){.label = "shadow map",
                                                        .target = GL_TEXTURE_2D_ARRAY,
                                                        .format = GL_DEPTH_COMPONENT32F,
                                                        .width = size,
                                                        .height = size,
                                                        .layers = desc->light_views}) &&
        framebuffer_init(&pass->framebuffer,
                         &(struct framebuffer_desc){.label = "shadow map", .depth = &pass->map}))
        return true;
    shadow_map_pass_free(pass);
    return false;
}

void shadow_map_pass_free(struct shadow_map_pass *pass) {
    program_free(&pass->opaque_program);
    program_free(&pass->masked_program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->map);
    *pass = (struct shadow_map_pass){0};
}

void shadow_map_pass_render(const struct shadow_map_pass *pass, const struct frame *frame) {
    struct pass_state state = {
        .name = "shadow map",
        .program = pass->opaque_program,
        .framebuffer = pass->framebuffer,
        .vertex_array = frame->scene->shaded_vertices,
        .width = pass->map.desc.width,
        .height = pass->map.desc.height,
        .depth = PASS_DEPTH_GREATER,
        .blocks = {{BLOCK_LIGHT, frame->light}},
    };
    pass_begin(frame->timers, &state);
    framebuffer_clear_depth(pass->framebuffer, 0);
    scene_gpu_draw_opaque(frame->scene, frame->light_views);
    if (frame->scene->has_masked) {
        state.program = pass->masked_program;
        pass_set_state(&state);
        scene_gpu_draw_masked(frame->scene, frame->light_views);
    }
    pass_end(frame->timers);
}
