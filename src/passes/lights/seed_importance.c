#include "passes/lights/seed_importance.h"

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "passes/vpls.h"
#include "shared/seed_importance.h"

static_assert(SEED_IMPORTANCE_SIDE == 1 << (SEED_IMPORTANCE_LEVELS - 1), "levels down to one cell");

static bool init_programs(struct seed_importance_pass *pass) {
    struct program_desc value = {.vertex = "passes/lights/seed_importance.vert",
                                 .fragment = "passes/lights/point.frag",
                                 .defines = "NUMBERS 0"};
    struct program_desc number = value;
    number.defines = "NUMBERS 1";
    return program_init(&pass->value_program, &value) &&
           program_init(&pass->number_program, &number) &&
           program_init(
               &pass->seed_program,
               &(struct program_desc){.screen = {"passes/lights/seed_importance_warp.frag"}});
}

static bool init_targets(struct seed_importance_pass *pass) {
    struct texture_desc cells = {.label = "importance",
                                 .format = GL_R32F,
                                 .width = SEED_IMPORTANCE_SIDE,
                                 .height = SEED_IMPORTANCE_SIDE};
    struct texture_desc pyramid = cells, row = cells;
    pyramid.levels = SEED_IMPORTANCE_LEVELS;
    pyramid.filter = FILTER_TRILINEAR;
    row.width = pass->desc.count;
    row.height = 1;
    return framebuffer_init_target(&pass->values, &pass->value_framebuffer, &pyramid) &&
           framebuffer_init_target(&pass->numbers, &pass->number_framebuffer, &cells) &&
           framebuffer_init_target(&pass->seeds, &pass->seed_framebuffer, &row);
}

bool seed_importance_pass_init(struct seed_importance_pass *pass,
                               const struct seed_importance_desc *desc) {
    *pass = (struct seed_importance_pass){.desc = *desc};
    if (init_programs(pass) && init_targets(pass) &&
        buffer_init(&pass->params, "importance parameters", sizeof(struct seed_importance_params),
                    NULL))
        return true;
    seed_importance_pass_free(pass);
    return false;
}

void seed_importance_pass_free(struct seed_importance_pass *pass) {
    programs_free(&pass->value_program, &pass->number_program, &pass->seed_program);
    framebuffers_free(&pass->value_framebuffer, &pass->number_framebuffer, &pass->seed_framebuffer);
    textures_free(&pass->values, &pass->numbers, &pass->seeds);
    buffer_free(&pass->params);
    *pass = (struct seed_importance_pass){0};
}

/* VPLs as points, onto the cells. */
static void scatter(const struct pass_state *common, GLuint program, GLuint framebuffer,
                    enum pass_blend blend, int count) {
    struct pass_state state = *common;
    state.program = program;
    state.framebuffer = framebuffer;
    state.blend = blend;
    framebuffer_clear_color(framebuffer, TARGET_RESULT, (float[]){0, 0, 0, 0});
    pass_set_state(&state);
    pass_draw(GL_POINTS, count, 1);
}

static void warp(const struct seed_importance_pass *pass) {
    gl.GenerateTextureMipmap(pass->values.id);
    pass_set_state(&(struct pass_state){
        .name = "importance",
        .program = pass->seed_program,
        .framebuffer = pass->seed_framebuffer,
        .width = pass->desc.count,
        .height = 1,
        .textures = {{UNIT_SEED_IMPORTANCE, pass->values.id}, {UNIT_VPL_NUMBERS, pass->numbers.id}},
    });
    pass_draw_fullscreen(1);
}

void seed_importance_pass_render(const struct seed_importance_pass *pass, const struct frame *frame,
                                 const struct gbuffer *gbuffer, const struct vpl_buffer *vpls,
                                 GLuint points) {
    struct seed_importance_params params = {
        .clamp_at = pass->desc.clamp_value / (frame->geometry->radius * frame->geometry->radius)};
    struct pass_state cells = {
        .name = "importance",
        .vertex_array = points,
        .width = SEED_IMPORTANCE_SIDE,
        .height = SEED_IMPORTANCE_SIDE,
        .textures = {{UNIT_VPLS, vpls->buffer.texels},
                     {UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
    timer_begin(frame->timers, "importance");
    buffer_write(&pass->params, 0, sizeof params, &params);
    scatter(&cells, pass->value_program, pass->value_framebuffer, PASS_BLEND_ADD, vpls->count);
    scatter(&cells, pass->number_program, pass->number_framebuffer, PASS_BLEND_OFF, vpls->count);
    warp(pass);
    timer_end(frame->timers);
}
