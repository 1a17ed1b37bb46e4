#include "passes/blur.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "shared/params.h"

bool blur_pass_init(struct blur_pass *pass, const struct blur_desc *desc) {
    *pass = (struct blur_pass){.desc = *desc};
    if (program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                            .fragment = "blur.frag"}) &&
        (desc->square || irradiance_init(&pass->half, "half-blurred irradiance", GL_RGBA16F,
                                         desc->width, desc->height, 1)) &&
        irradiance_init(&pass->blurred, "blurred irradiance", GL_RGBA16F, desc->width, desc->height,
                        1) &&
        buffer_init(&pass->params[0], "blur parameters", sizeof(struct blur_params), NULL) &&
        buffer_init(&pass->params[1], "blur parameters", sizeof(struct blur_params), NULL))
        return true;
    blur_pass_free(pass);
    return false;
}

void blur_pass_free(struct blur_pass *pass) {
    program_free(&pass->program);
    irradiance_free(&pass->half);
    irradiance_free(&pass->blurred);
    buffer_free(&pass->params[0]);
    buffer_free(&pass->params[1]);
    *pass = (struct blur_pass){0};
}

static void blur(const struct blur_pass *pass, const struct frame *frame,
                 const struct gbuffer *gbuffer, const struct irradiance *source,
                 const struct irradiance *target, int axis) {
    float distance = pass->desc.distance * 2 * frame->radius;
    struct blur_params params = {
        .interleave = (float)source->interleave,
        .tile_width = (float)source->tile_width,
        .tile_height = (float)source->tile_height,
        .radius = (float)pass->desc.radius,
        .radius_y = pass->desc.square ? (float)pass->desc.radius : 0,
        .direction = {axis == 0, axis == 1},
        .distance2 = distance * distance,
        .cosine = pass->desc.cosine,
    };
    buffer_write(&pass->params[axis], 0, sizeof params, &params);
    pass_set_state(&(struct pass_state){
        .name = "blur",
        .program = pass->program,
        .framebuffer = target->framebuffer,
        .width = target->width,
        .height = target->height,
    });
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_PASS, pass->params[axis].id);
    gl.BindTextureUnit(0, gbuffer->depth.id);
    gl.BindTextureUnit(1, gbuffer->normal.id);
    gl.BindTextureUnit(2, source->texture.id);
    pass_draw_fullscreen(1);
}

void blur_pass_render(const struct blur_pass *pass, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct irradiance *source) {
    timer_begin(frame->timers, "blur");
    if (pass->desc.square) {
        blur(pass, frame, gbuffer, source, &pass->blurred, 0);
    } else {
        blur(pass, frame, gbuffer, source, &pass->half, 0);
        blur(pass, frame, gbuffer, &pass->half, &pass->blurred, 1);
    }
    timer_end(frame->timers);
}
