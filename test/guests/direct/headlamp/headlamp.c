/* Light from where the camera is, of the same strength near and far: a guest of the house for its
 * tests. */
#include "base/memory.h"
#include "direct/direct.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"

#include <stdlib.h>

struct headlamp {
    GLuint program, framebuffer;
    struct texture light;
};

static bool resize(void *state, int width, int height) {
    struct headlamp *headlamp = state, fresh = {0};
    if (!texture_init(&fresh.light, &(struct texture_desc){.label = "direct",
                                                           .format = GL_RGBA32F,
                                                           .width = width,
                                                           .height = height}))
        return false;
    if (!framebuffer_init(&fresh.framebuffer, &(struct framebuffer_desc){
                                                  .label = "direct", .colors = {&fresh.light}})) {
        texture_free(&fresh.light);
        return false;
    }
    framebuffer_free(&headlamp->framebuffer);
    texture_free(&headlamp->light);
    headlamp->light = fresh.light;
    headlamp->framebuffer = fresh.framebuffer;
    return true;
}

static bool init(void **state, const struct direct_desc *desc) {
    struct headlamp *headlamp = *state = mem_alloc(1, sizeof *headlamp);
    return program_init(&headlamp->program,
                        &(struct program_desc){.vertex = "fullscreen.vert",
                                               .fragment = "direct/headlamp/headlamp.frag"}) &&
           resize(headlamp, desc->width, desc->height);
}

static void free_state(void *state) {
    struct headlamp *headlamp = state;
    if (headlamp) {
        program_free(&headlamp->program);
        framebuffer_free(&headlamp->framebuffer);
        texture_free(&headlamp->light);
    }
    free(headlamp);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct headlamp *headlamp = state;
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "direct",
                                  .program = headlamp->program,
                                  .framebuffer = headlamp->framebuffer,
                                  .width = gbuffer->width,
                                  .height = gbuffer->height,
                                  .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                               {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
                                  .blocks = {{BLOCK_VIEW, frame->view}},
                              });
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}

static const struct texture *light(const void *state) {
    const struct headlamp *headlamp = state;
    return &headlamp->light;
}

static const struct settings_part *const parts[] = {NULL};

extern const struct direct_method headlamp_direct;
const struct direct_method headlamp_direct = {
    .name = "headlamp",
    .help = "a lamp on the camera, without shadows",
    .parts = parts,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_view = render_view,
    .light = light,
};
