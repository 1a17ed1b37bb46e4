#include "passes/visibility/shadow_map.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/bindings.h"

static bool init_maps(struct shadow_map_pass *pass, int kind, int size, int layers) {
    return layers == 0 ||
           (texture_init(&pass->maps[kind], &(struct texture_desc){.label = "shadow map",
                                                                   .target = GL_TEXTURE_2D_ARRAY,
                                                                   .format = GL_DEPTH_COMPONENT32F,
                                                                   .width = size,
                                                                   .height = size,
                                                                   .layers = layers}) &&
            framebuffer_init(
                &pass->framebuffers[kind],
                &(struct framebuffer_desc){.label = "shadow map", .depth = &pass->maps[kind]}));
}

bool shadow_map_pass_init(struct shadow_map_pass *pass, const struct shadow_map_desc *desc) {
    *pass = (struct shadow_map_pass){0};
    bool ok = program_init(&pass->opaque_program,
                           &(struct program_desc){.vertex = "passes/visibility/shadow_map.vert",
                                                  .fragment = "passes/picture/depth.frag"}) &&
              program_init(&pass->masked_program,
                           &(struct program_desc){.vertex = "passes/picture/geometry.vert",
                                                  .fragment = "passes/picture/depth.frag",
                                                  .defines = "LIGHT_VIEW;MASKED"});
    for (int kind = 0; ok && kind < LIGHT_MAP_KINDS; kind++)
        ok = init_maps(pass, kind, light_map_size(kind, desc->size), desc->lights.views[kind]);
    if (!ok)
        shadow_map_pass_free(pass);
    return ok;
}

void shadow_map_pass_free(struct shadow_map_pass *pass) {
    programs_free(&pass->opaque_program, &pass->masked_program);
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        framebuffer_free(&pass->framebuffers[kind]);
        texture_free(&pass->maps[kind]);
    }
    *pass = (struct shadow_map_pass){0};
}

/* Error of levels of detail, texels. */
static const float map_error = .25F;

static void render_kind(const struct shadow_map_pass *pass, const struct frame *frame, int kind) {
    struct pass_state state = {
        .name = "shadow map",
        .program = pass->opaque_program,
        .framebuffer = pass->framebuffers[kind],
        .vertex_array = frame->scene->shaded_vertices,
        .width = pass->maps[kind].desc.width,
        .height = pass->maps[kind].desc.height,
        .depth = PASS_DEPTH_GREATER,
        .blocks = {{BLOCK_LIGHTS, frame->lights}},
    };
    pass_set_state(&state);
    framebuffer_clear_depth(state.framebuffer, 0);
    struct draw_views views = frame_light_views(frame, kind, state.program);
    views.coarseness = 2 * map_error / (float)state.width;
    scene_gpu_draw_opaque(frame->scene, &views);
    if (frame->scene->has_masked) {
        state.program = views.program = pass->masked_program;
        pass_set_state(&state);
        scene_gpu_draw_masked(frame->scene, &views);
    }
}

void shadow_map_pass_render(const struct shadow_map_pass *pass, const struct frame *frame) {
    timer_begin(frame->timers, "shadow map");
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        if (frame->layout.views[kind])
            render_kind(pass, frame, kind);
    timer_end(frame->timers);
}
