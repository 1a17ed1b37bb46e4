#include "passes/direct.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/params.h"

static bool init_programs(struct direct_pass *pass) {
    return program_init(&pass->opaque_program,
                        &(struct program_desc){.vertex = "shadow_map.vert",
                                               .fragment = "depth_only.frag"}) &&
           program_init(&pass->masked_program,
                        &(struct program_desc){.vertex = "geometry.vert",
                                               .fragment = "geometry.frag",
                                               .defines = "LIGHT_VIEW;DEPTH_ONLY"}) &&
           program_init(&pass->direct_program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                                      .fragment = "direct.frag"});
}

static bool init_targets(struct direct_pass *pass) {
    return texture_init(&pass->shadow_map,
                        &(struct texture_desc){
                            .label = "shadow map",
                            .target = GL_TEXTURE_2D_ARRAY,
                            .format = GL_DEPTH_COMPONENT32F,
                            .width = pass->shadow_size,
                            .height = pass->shadow_size,
                            .layers = pass->desc.light_views,
                        }) &&
           texture_init(&pass->direct,
                        &(struct texture_desc){
                            .label = "direct",
                            .format = GL_R32F,
                            .width = pass->desc.width,
                            .height = pass->desc.height,
                        }) &&
           framebuffer_init(
               &pass->shadow_framebuffer,
               &(struct framebuffer_desc){.label = "shadow map", .depth = &pass->shadow_map}) &&
           framebuffer_init(
               &pass->direct_framebuffer,
               &(struct framebuffer_desc){.label = "direct", .colors = {&pass->direct}});
}

bool direct_pass_init(struct direct_pass *pass, const struct direct_desc *desc) {
    *pass = (struct direct_pass){.desc = *desc};
    pass->shadow_size = desc->light_views > 1 ? (desc->shadow_size + 1) / 2 : desc->shadow_size;
    struct direct_params params = {.bias = desc->bias, .shadow_size = (float)pass->shadow_size};
    if (init_programs(pass) && init_targets(pass) &&
        buffer_init(&pass->params, "direct parameters", sizeof params, &params))
        return true;
    direct_pass_free(pass);
    return false;
}

void direct_pass_free(struct direct_pass *pass) {
    program_free(&pass->opaque_program);
    program_free(&pass->masked_program);
    program_free(&pass->direct_program);
    framebuffer_free(&pass->shadow_framebuffer);
    framebuffer_free(&pass->direct_framebuffer);
    texture_free(&pass->shadow_map);
    texture_free(&pass->direct);
    buffer_free(&pass->params);
    *pass = (struct direct_pass){0};
}

void direct_pass_render_shadow_map(const struct direct_pass *pass, const struct frame *frame) {
    static const float far = 0;
    struct pass_state state = {
        .name = "shadow map",
        .program = pass->opaque_program,
        .framebuffer = pass->shadow_framebuffer,
        .vertex_array = frame->scene->shaded_vertices,
        .width = pass->shadow_size,
        .height = pass->shadow_size,
        .depth = PASS_DEPTH_GREATER,
    };
    pass_begin(frame->timers, &state);
    gl.ClearNamedFramebufferfv(pass->shadow_framebuffer, GL_DEPTH, 0, &far);
    scene_gpu_draw_opaque(frame->scene, frame->light_views);
    if (frame->scene->masked_caster_count) {
        state.program = pass->masked_program;
        pass_set_state(&state);
        scene_gpu_draw_masked(frame->scene, frame->light_views);
    }
    pass_end(frame->timers);
}

void direct_pass_render(const struct direct_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer) {
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "direct",
                                  .program = pass->direct_program,
                                  .framebuffer = pass->direct_framebuffer,
                                  .width = pass->desc.width,
                                  .height = pass->desc.height,
                              });
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_PASS, pass->params.id);
    gl.BindTextureUnit(0, gbuffer->depth.id);
    gl.BindTextureUnit(1, gbuffer->normal.id);
    gl.BindTextureUnit(2, pass->shadow_map.id);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
