#include "passes/gather/blur.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "shared/blur.h"

#include <math.h>

static bool init_programs(struct blur_pass *pass) {
    struct program_desc desc = {.vertex = "fullscreen.vert", .fragment = "gather/blur.frag"};
    struct program_desc half = desc, pack = desc;
    half.defines = "PACK 1";
    pack.fragment = "gather/blur_pack.frag";
    pack.defines = pass->desc.gloss    ? "DETAIL 0;GLOSS 1"
                   : pass->desc.detail ? "DETAIL 1;GLOSS 0"
                                       : "DETAIL 0;GLOSS 0";
    return program_init(&pass->pack_program, &pack) && program_init(&pass->half_program, &half) &&
           program_init(&pass->program, &desc);
}

static bool init_target(struct irradiance *target, const char *label, GLenum format,
                        const struct blur_desc *desc) {
    return irradiance_init(target, label, format, desc->width, desc->height, 1);
}

bool blur_pass_init(struct blur_pass *pass, const struct blur_desc *desc) {
    *pass = (struct blur_pass){.desc = *desc};
    if (init_programs(pass) && init_target(&pass->taps, "blur taps", GL_RGBA32UI, desc) &&
        (desc->square || init_target(&pass->half, "blur taps", GL_RGBA32UI, desc)) &&
        init_target(&pass->blurred, "blurred irradiance", GL_RGBA16F, desc) &&
        buffer_init(&pass->params[0], "blur parameters", sizeof(struct blur_params), NULL) &&
        buffer_init(&pass->params[1], "blur parameters", sizeof(struct blur_params), NULL))
        return true;
    blur_pass_free(pass);
    return false;
}

void blur_pass_free(struct blur_pass *pass) {
    program_free(&pass->pack_program);
    program_free(&pass->half_program);
    program_free(&pass->program);
    irradiance_free(&pass->taps);
    irradiance_free(&pass->half);
    irradiance_free(&pass->blurred);
    buffer_free(&pass->params[0]);
    buffer_free(&pass->params[1]);
    *pass = (struct blur_pass){0};
}

/* Of what a list has another pixel takes within the mean of their windows: of its own it would take light that does
 * not come back, and of theirs places of the pattern would be missing, the same ones all along a slanted edge. What is
 * smooth gloss is never blurred. */
static float taken_radius(const struct blur_desc *desc, int grade) {
    float own = (float)desc->radius, theirs = desc->grade_radius[grade];
    return desc->gloss ? fminf(own, theirs) : .5F * (own + theirs);
}

static void write_params(const struct blur_pass *pass, const struct irradiance *source) {
    const struct blur_desc *desc = &pass->desc;
    for (int axis = 0; axis < 2; axis++) {
        struct blur_params params = {
            .pattern = irradiance_pattern(source),
            .along = {axis == 0, axis == 1},
            .radius = desc->radius,
            .rows = desc->square ? desc->radius : 0,
            .distance = desc->distance,
            .cosine = desc->cosine,
            .radii = {(float)desc->radius, desc->grade_radius[0], desc->grade_radius[1]},
            .taken_radii = {(float)desc->radius, taken_radius(desc, 0), taken_radius(desc, 1)},
            .weights = {1, desc->grade_weight[0], desc->grade_weight[1]},
        };
        buffer_write(&pass->params[axis], 0, sizeof params, &params);
    }
}

static void pack(const struct blur_pass *pass, const struct frame *frame,
                 const struct gbuffer *gbuffer, const struct blur_inputs *inputs) {
    struct pass_state state = {
        .name = "blur",
        .program = pass->pack_program,
        .framebuffer = pass->taps.framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                     {UNIT_IRRADIANCE, inputs->source->texture.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params[0]}},
    };
    if (pass->desc.gloss)
        pass_add_texture(&state, UNIT_GBUFFER_GLOSS, gbuffer->gloss.id);
    if (inputs->lists) {
        pass_add_texture(&state, UNIT_LIST_TEXELS, inputs->lists->texels.id);
        pass_add_texture(&state, UNIT_DETAIL_IRRADIANCE, inputs->detail->texture.id);
    }
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

static void blur(const struct blur_pass *pass, const struct frame *frame, GLuint program,
                 const struct irradiance *from, const struct irradiance *to, int axis) {
    pass_set_state(&(struct pass_state){
        .name = "blur",
        .program = program,
        .framebuffer = to->framebuffer,
        .width = to->width,
        .height = to->height,
        .textures = {{UNIT_BLUR_TAPS, from->texture.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params[axis]}},
    });
    pass_draw_fullscreen(1);
}

void blur_pass_render(const struct blur_pass *pass, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct blur_inputs *inputs) {
    timer_begin(frame->timers, "blur");
    write_params(pass, inputs->source);
    pack(pass, frame, gbuffer, inputs);
    if (pass->desc.square) {
        blur(pass, frame, pass->program, &pass->taps, &pass->blurred, 0);
    } else {
        blur(pass, frame, pass->half_program, &pass->taps, &pass->half, 0);
        blur(pass, frame, pass->program, &pass->half, &pass->blurred, 1);
    }
    timer_end(frame->timers);
}
