#include "passes/picture/triangles.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "shared/bindings.h"

#include <stdlib.h>
#include <string.h>

/* Objects of one read. */
struct target {
    struct texture triangles, depth;
    GLuint framebuffer, program;
    struct buffer view;
};

static bool target_init(struct target *target, const struct view *view, int width, int height) {
    struct texture_desc desc = {
        .label = "triangles", .format = GL_R32UI, .width = width, .height = height};
    struct texture_desc depth = desc;
    depth.format = GL_DEPTH_COMPONENT32F;
    return texture_init(&target->triangles, &desc) && texture_init(&target->depth, &depth) &&
           framebuffer_init(&target->framebuffer,
                            &(struct framebuffer_desc){.label = "triangles",
                                                       .colors = {&target->triangles},
                                                       .depth = &target->depth}) &&
           buffer_init(&target->view, "view of triangles", sizeof *view, view) &&
           program_init(&target->program,
                        &(struct program_desc){.vertex = "passes/picture/geometry.vert",
                                               .fragment = "passes/picture/triangles.frag"});
}

static void target_free(struct target *target) {
    program_free(&target->program);
    framebuffer_free(&target->framebuffer);
    textures_free(&target->triangles, &target->depth);
    buffer_free(&target->view);
}

static void draw(const struct target *target, const struct frame *frame, int width, int height) {
    static const unsigned none[4] = {0};
    struct pass_state state = {.name = "triangles",
                               .program = target->program,
                               .framebuffer = target->framebuffer,
                               .vertex_array = frame->scene->shaded_vertices,
                               .width = width,
                               .height = height,
                               .depth = PASS_DEPTH_GREATER,
                               .blocks = {{BLOCK_VIEW, &target->view}}};
    struct draw_views views = frame_camera_views(frame, 1, 0);
    frame_cut_by_range(frame, &state);
    pass_set_state(&state);
    framebuffer_clear_integers(target->framebuffer, TARGET_RESULT, none);
    framebuffer_clear_depth(target->framebuffer, 0);
    scene_gpu_draw_numbered(frame->scene, &views, target->program);
}

uint32_t *triangles_read(const struct frame *frame, const struct camera *camera, int width,
                         int height, const float place[2]) {
    struct target target = {.program = 0};
    struct view view;
    struct frame centred = *frame;
    size_t row = (size_t)width, count = row * (size_t)height;
    uint32_t *flipped = NULL;
    view_of_camera(&view, camera, frame->geometry, (float)width / (float)height);
    view_shift(&view, (float[2]){2 * place[0] / (float)width, 2 * place[1] / (float)height});
    centred.camera = &view;
    if (target_init(&target, &view, width, height)) {
        draw(&target, &centred, width, height);
        uint32_t *read = mem_alloc(count, sizeof *read);
        flipped = mem_alloc(count, sizeof *flipped);
        gl.GetTextureImage(target.triangles.id, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                           (GLsizei)(count * sizeof *read), read);
        for (size_t y = 0; y < (size_t)height; y++)
            memcpy(flipped + y * row, read + ((size_t)height - 1 - y) * row, row * sizeof *read);
        free(read);
    }
    target_free(&target);
    return flipped;
}
