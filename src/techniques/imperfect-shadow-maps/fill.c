#include "techniques/imperfect-shadow-maps/fill.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"

/* A map's depth can only be drawn. */
static bool init_programs(struct fill_pass *pass) {
    const struct screen_desc fill = {"techniques/imperfect-shadow-maps/fill.frag", .layers = true};
    return program_init(&pass->pull_program,
                        &(struct program_desc){.screen = fill, .defines = "PULL"}) &&
           program_init(&pass->push_program,
                        &(struct program_desc){.screen = fill, .defines = "TO_MAP 0"}) &&
           program_init(&pass->map_program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                                   .fragment = fill.body,
                                                                   .defines = "TO_MAP 1;LAYERS"});
}

/* Of level l + 1. */
static int level_size(const struct fill_pass *pass, int l) {
    int size = pass->maps.size >> (l + 1);
    return size > 1 ? size : 1;
}

static bool init_level(const struct fill_pass *pass, int l, const char *label,
                       struct texture *texture, GLuint *framebuffer) {
    return framebuffer_init_target(texture, framebuffer,
                                   &(struct texture_desc){.label = label,
                                                          .target = GL_TEXTURE_2D_ARRAY,
                                                          .format = GL_R16,
                                                          .width = level_size(pass, l),
                                                          .height = level_size(pass, l),
                                                          .layers = pass->maps.count});
}

static bool init_levels(struct fill_pass *pass) {
    bool ok = true;
    for (int l = 0; ok && l < FILL_LEVELS; l++)
        ok = init_level(pass, l, "pulled depth", &pass->pulled[l], &pass->pulled_framebuffers[l]);
    for (int l = 0; ok && l < FILL_LEVELS - 1; l++)
        ok = init_level(pass, l, "pushed depth", &pass->pushed[l], &pass->pushed_framebuffers[l]);
    return ok;
}

bool fill_pass_init(struct fill_pass *pass, int size, int count) {
    *pass = (struct fill_pass){0};
    if (depth_maps_init(&pass->maps, &(struct depth_maps_desc){"filled", size, count, false}) &&
        init_programs(pass) && init_levels(pass) &&
        buffer_init(&pass->params, "fill parameters", sizeof(struct fill_params), NULL))
        return true;
    fill_pass_free(pass);
    return false;
}

void fill_pass_free(struct fill_pass *pass) {
    programs_free(&pass->pull_program, &pass->push_program, &pass->map_program);
    for (int l = 0; l < FILL_LEVELS; l++) {
        framebuffers_free(&pass->pulled_framebuffers[l], &pass->pushed_framebuffers[l]);
        textures_free(&pass->pulled[l], &pass->pushed[l]);
    }
    depth_maps_free(&pass->maps);
    buffer_free(&pass->params);
    *pass = (struct fill_pass){0};
}

/* One step: from fine texels of a level, and from coarse ones or 0. */
static void draw_step(const struct fill_pass *pass, struct pass_state state,
                      const struct map_views *views, GLuint coarse, struct fill_params params) {
    params.map_size = (float)pass->maps.size;
    buffer_write(&pass->params, 0, sizeof params, &params);
    state.name = "fill";
    state.height = state.width;
    pass_add_block(&state, BLOCK_MAPS, &views->buffer);
    pass_add_block(&state, BLOCK_PASS, &pass->params);
    if (coarse)
        pass_add_texture(&state, UNIT_COARSE_DEPTH, coarse);
    pass_set_state(&state);
    gl.ProgramUniform1i(state.program, LOCATION_FIRST_LAYER, 0);
    pass_draw_fullscreen(views->count);
}

void fill_pass_render(struct fill_pass *pass, const struct frame *frame,
                      const struct depth_maps *holes, const struct map_views *views, float radius) {
    timer_begin(frame->timers, "fill");
    for (int l = 0; l < FILL_LEVELS; l++) {
        GLuint fine = l == 0 ? holes->depth.id : pass->pulled[l - 1].id;
        draw_step(pass,
                  (struct pass_state){.program = pass->pull_program,
                                      .framebuffer = pass->pulled_framebuffers[l],
                                      .width = level_size(pass, l),
                                      .textures = {{UNIT_MAP_DEPTH, fine}}},
                  views, 0, (struct fill_params){.level = l, .radius = radius});
    }
    GLuint coarse = pass->pulled[FILL_LEVELS - 1].id;
    for (int l = FILL_LEVELS - 2; l >= 0; coarse = pass->pushed[l].id, l--)
        draw_step(pass,
                  (struct pass_state){.program = pass->push_program,
                                      .framebuffer = pass->pushed_framebuffers[l],
                                      .width = level_size(pass, l),
                                      .textures = {{UNIT_MAP_DEPTH, pass->pulled[l].id}}},
                  views, coarse, (struct fill_params){.level = l + 1, .radius = radius});
    framebuffer_clear_depth(pass->maps.framebuffer, 1);
    draw_step(pass,
              (struct pass_state){.program = pass->map_program,
                                  .framebuffer = pass->maps.framebuffer,
                                  .width = pass->maps.size,
                                  .depth = PASS_DEPTH_LESS,
                                  .textures = {{UNIT_MAP_DEPTH, holes->depth.id}}},
              views, coarse, (struct fill_params){.level = 0, .radius = radius});
    timer_end(frame->timers);
}
