#include "passes/lights/vpl_weight.h"

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"

static bool init_programs(struct vpl_weight_pass *pass) {
    const struct screen_desc screen = {.body = "passes/lights/vpl_weight.frag"};
    return program_init(&pass->program, &(struct program_desc){.screen = screen}) &&
           program_init(&pass->sum_program,
                        &(struct program_desc){.screen = screen, .defines = "SUM"});
}

static bool init_row(struct texture *texture, GLuint *framebuffer, GLenum format, int width) {
    return framebuffer_init_target(
        texture, framebuffer,
        &(struct texture_desc){.label = "weights of VPLs", .format = format, .width = width});
}

bool vpl_weight_pass_init(struct vpl_weight_pass *pass, int vpl_count) {
    *pass = (struct vpl_weight_pass){0};
    if (init_programs(pass) &&
        init_row(&pass->weights.values, &pass->value_framebuffer, GL_R32F, vpl_count) &&
        init_row(&pass->weights.sum, &pass->sum_framebuffer, GL_RGBA32F, 1))
        return true;
    vpl_weight_pass_free(pass);
    return false;
}

void vpl_weight_pass_free(struct vpl_weight_pass *pass) {
    programs_free(&pass->program, &pass->sum_program);
    framebuffers_free(&pass->value_framebuffer, &pass->sum_framebuffer);
    textures_free(&pass->weights.values, &pass->weights.sum);
    *pass = (struct vpl_weight_pass){0};
}

static struct pass_state row_state(GLuint program, GLuint framebuffer, const struct texture *row,
                                   const struct vpl_buffer *vpls) {
    return (struct pass_state){
        .name = "importance",
        .program = program,
        .framebuffer = framebuffer,
        .width = row->desc.width,
        .height = 1,
        .textures = {{UNIT_VPLS, vpls->buffer.texels}},
    };
}

static void draw_row(const struct pass_state *state) {
    pass_set_state(state);
    pass_draw_fullscreen(1);
}

void vpl_weight_pass_render(const struct vpl_weight_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct vpl_buffer *vpls) {
    struct pass_state values = row_state(pass->program, pass->value_framebuffer,
                                         &pass->weights.values, vpls),
                      sum = row_state(pass->sum_program, pass->sum_framebuffer, &pass->weights.sum,
                                      vpls);
    pass_add_block(&values, BLOCK_VIEW, frame->view);
    pass_add_texture(&values, UNIT_GBUFFER_DEPTH, gbuffer->depth.id);
    pass_add_texture(&values, UNIT_GBUFFER_NORMAL, gbuffer->normal.id);
    pass_add_texture(&sum, UNIT_VPL_VALUES, pass->weights.values.id);
    timer_begin(frame->timers, "importance");
    draw_row(&values);
    draw_row(&sum);
    timer_end(frame->timers);
}
