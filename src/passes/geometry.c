#include "passes/geometry.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "shared/bindings.h"

bool geometry_pass_init(struct geometry_pass *pass) {
    *pass = (struct geometry_pass){0};
    struct program_desc desc = {.vertex = "geometry.vert", .fragment = "geometry.frag"};
    struct program_desc light_desc = desc;
    light_desc.defines = "LIGHT_VIEW";
    if (program_init(&pass->camera_program, &desc) &&
        program_init(&pass->light_program, &light_desc))
        return true;
    geometry_pass_free(pass);
    return false;
}

void geometry_pass_free(struct geometry_pass *pass) {
    program_free(&pass->camera_program);
    program_free(&pass->light_program);
}

static void render(const char *name, GLuint program, const struct frame *frame,
                   const struct gbuffer *gbuffer, int views) {
    static const float zero[4] = {0};
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = name,
                                  .program = program,
                                  .framebuffer = gbuffer->framebuffer,
                                  .vertex_array = frame->scene->shaded_vertices,
                                  .width = gbuffer->width,
                                  .height = gbuffer->height,
                                  .depth = PASS_DEPTH_GREATER,
                              });
    gl.ClearNamedFramebufferfv(gbuffer->framebuffer, GL_COLOR, TARGET_GBUFFER_NORMAL, zero);
    gl.ClearNamedFramebufferfv(gbuffer->framebuffer, GL_COLOR, TARGET_GBUFFER_ALBEDO, zero);
    gl.ClearNamedFramebufferfv(gbuffer->framebuffer, GL_DEPTH, 0, zero);
    scene_gpu_draw_shaded(frame->scene, views);
    pass_end(frame->timers);
}

void geometry_pass_render_camera(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer *gbuffer) {
    render("gbuffer", pass->camera_program, frame, gbuffer, 1);
}

void geometry_pass_render_light(const struct geometry_pass *pass, const struct frame *frame,
                                const struct gbuffer *rsm) {
    render("rsm", pass->light_program, frame, rsm, frame->light_views);
}
