#include "passes/gather/plain.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/plain.h"
#include "shared/planes.h"

#include <cglm/util.h>

#include <math.h>

static bool init_programs(struct plain_pass *pass) {
    struct program_desc around = {.screen = {"gather/plain_around.frag"}, .defines = "ERODE 0"};
    struct program_desc erode = around;
    erode.defines = "ERODE 1";
    return program_init(&pass->around_program, &around) &&
           program_init(&pass->erode_program, &erode) &&
           program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                               .fragment = "gather/plain.frag"});
}

static bool init_blocks(struct plain_pass *pass) {
    const struct plain_desc *desc = &pass->desc;
    bool ok = true;
    for (int i = 0; ok && i < 2; i++)
        ok = block_texture_init(&pass->blocks[i], "plain blocks", GL_R8, desc->width,
                                desc->height) &&
             framebuffer_init(
                 &pass->block_framebuffers[i],
                 &(struct framebuffer_desc){.label = "plain blocks", .colors = {&pass->blocks[i]}});
    return ok;
}

static bool init_pixels(struct plain_pass *pass) {
    return texture_init(&pass->pixels, &(struct texture_desc){.label = "plain pixels",
                                                              .format = GL_DEPTH_COMPONENT16,
                                                              .width = pass->desc.width,
                                                              .height = pass->desc.height}) &&
           framebuffer_init(&pass->framebuffer, &(struct framebuffer_desc){.label = "plain pixels",
                                                                           .depth = &pass->pixels});
}

/* Of normals that may count as those of one plane, radians. */
static const float turn_max = .0175F;
/* The angle between two unit vectors is at most so many times the sum of what their octahedral codes differ by: where
 * the code is 2/3, 2/3, at (1, 1, 1). */
static const float angle_per_code = 4.9F;

static bool init_params(struct plain_pass *pass) {
    const struct plain_desc *desc = &pass->desc;
    /* Three steps, from a pixel to its block, to another, to a pixel of that. */
    float turn = fminf(turn_max, acosf(glm_clamp(desc->cosine, -1, 1)) / 3);
    struct plain_params params = {
        .distance = desc->distance,
        .code_apart = turn / angle_per_code,
        .width = desc->width,
        .reach = (desc->radius + PLANE_BLOCK - 1) / PLANE_BLOCK,
    };
    return buffer_init(&pass->params, "plain parameters", sizeof params, &params);
}

bool plain_pass_init(struct plain_pass *pass, const struct plain_desc *desc) {
    *pass = (struct plain_pass){.desc = *desc};
    if (init_programs(pass) && init_blocks(pass) && init_pixels(pass) && init_params(pass))
        return true;
    plain_pass_free(pass);
    return false;
}

void plain_pass_free(struct plain_pass *pass) {
    program_free(&pass->around_program);
    program_free(&pass->erode_program);
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->pixels);
    for (int i = 0; i < 2; i++) {
        framebuffer_free(&pass->block_framebuffers[i]);
        texture_free(&pass->blocks[i]);
    }
    buffer_free(&pass->params);
    *pass = (struct plain_pass){0};
}

/* The state of a draw over all blocks. */
static struct pass_state over_blocks(const struct plain_pass *pass, const struct frame *frame,
                                     GLuint program, GLuint framebuffer) {
    return (struct pass_state){
        .name = "plain",
        .program = program,
        .framebuffer = framebuffer,
        .width = pass->blocks[0].desc.width,
        .height = pass->blocks[0].desc.height,
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
    };
}

static void compare_blocks(const struct plain_pass *pass, const struct frame *frame) {
    struct pass_state around =
        over_blocks(pass, frame, pass->around_program, pass->block_framebuffers[0]);
    block_planes_add(&around, frame->planes);
    pass_set_state(&around);
    pass_draw_fullscreen(1);
    struct pass_state erode =
        over_blocks(pass, frame, pass->erode_program, pass->block_framebuffers[1]);
    pass_add_texture(&erode, UNIT_PLAIN_BLOCKS, pass->blocks[0].id);
    pass_set_state(&erode);
    pass_draw_fullscreen(1);
}

static void mark_pixels(const struct plain_pass *pass, const struct frame *frame) {
    framebuffer_clear_depth(pass->framebuffer, 1);
    pass_set_state(&(struct pass_state){
        .name = "plain",
        .program = pass->program,
        .framebuffer = pass->framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .depth = PASS_DEPTH_LESS,
        .textures = {{UNIT_PLAIN_BLOCKS, pass->blocks[1].id},
                     {UNIT_SAMPLE_PICKS, frame->picks->id}},
    });
    pass_draw_fullscreen(1);
}

void plain_pass_render(const struct plain_pass *pass, const struct frame *frame) {
    timer_begin(frame->timers, "plain");
    compare_blocks(pass, frame);
    mark_pixels(pass, frame);
    timer_end(frame->timers);
}
