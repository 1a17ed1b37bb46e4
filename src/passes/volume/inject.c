#include "passes/volume/inject.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "passes/volumes.h"

static bool init_program(GLuint *program, const struct volume *volume, bool slides, bool pixels) {
    bool lit = volume->desc.channels == VOLUME_RADIANCE;
    char *own = volume_defines(volume);
    char *defines =
        mem_printf("%s%s%s", light_defines(false, lit && slides), pixels ? "PIXELS;" : "", own);
    bool ok = program_init(program, &(struct program_desc){.vertex = "passes/volume/inject.vert",
                                                           .fragment = "passes/volume/inject.frag",
                                                           .defines = defines});
    mem_free(own, defines);
    return ok;
}

bool inject_pass_init(struct inject_pass *pass, const struct volume *volume, bool reprojects,
                      bool slides) {
    *pass = (struct inject_pass){0};
    bool ok = init_program(&pass->program, volume, slides, false) &&
              (!reprojects || init_program(&pass->pixel_program, volume, slides, true));
    if (!ok)
        inject_pass_free(pass);
    return ok;
}

void inject_pass_free(struct inject_pass *pass) {
    programs_free(&pass->program, &pass->pixel_program);
    *pass = (struct inject_pass){0};
}

static void clear(const struct volume *volume) {
    static const float none[4] = {0};
    int targets = volume->desc.channels == VOLUME_RADIANCE
                      ? 2 + volume->desc.both_sides + volume->desc.bounces +
                            2 * volume_is_split(&volume->desc)
                      : 1;
    for (int i = 0; i < targets; i++)
        framebuffer_clear_color(volume->points_framebuffer, i, none);
}

/* Into the volume's sums. */
static struct pass_state adding(const char *name, GLuint program, const struct frame *frame,
                                const struct volume *volume, const struct buffer *params,
                                const struct texture *shadow_maps) {
    struct pass_state state = {
        .name = name,
        .program = program,
        .framebuffer = volume->points_framebuffer,
        .width = volume->grid.width,
        .height = volume->grid.height,
        .blend = PASS_BLEND_ADD,
        .blocks = {{BLOCK_PASS, params}},
    };
    if (!shadow_maps)
        return state;
    pass_add_block(&state, BLOCK_LIGHTS, frame->lights);
    frame_add_light(frame, &state);
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        bool has = shadow_maps[kind].id;
        pass_add_texture(&state, UNIT_VOLUME_SHADOWS + (GLuint)kind,
                         shadow_maps[has ? kind : !kind].id);
    }
    return state;
}

void inject_pass_render(const struct inject_pass *pass, const struct frame *frame,
                        const struct volume *volume, const struct buffer *params,
                        const struct volume_points *points, const struct texture *shadow_maps) {
    struct pass_state state = adding("inject", pass->program, frame, volume, params, shadow_maps);
    state.vertex_array = points->vertices;
    pass_begin(frame->timers, &state);
    clear(volume);
    pass_draw(GL_POINTS, points->points.count, 1);
    pass_end(frame->timers);
}

void inject_pass_add_pixels(const struct inject_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct volume *volume,
                            const struct buffer *params, const struct texture *shadow_maps) {
    struct pass_state state =
        adding("reproject", pass->pixel_program, frame, volume, params, shadow_maps);
    pass_add_block(&state, BLOCK_VIEW, frame->view);
    pass_add_texture(&state, UNIT_GBUFFER_DEPTH, gbuffer->depth.id);
    pass_add_texture(&state, UNIT_GBUFFER_NORMAL, gbuffer->normal.id);
    pass_add_texture(&state, UNIT_GBUFFER_ALBEDO, gbuffer->albedo.id);
    pass_begin(frame->timers, &state);
    pass_draw(GL_POINTS, VOLUME_PIXELS * VOLUME_PIXELS, 1);
    pass_end(frame->timers);
}
