#include "passes/gather/blur.h"

#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/lists.h"
#include "shared/gather.h"

#include <math.h>
#include <stdio.h>

/* Makes one axis. With `pack` it writes packed taps for the next axis. */
static bool init_axis(struct blur_axis *axis, bool pack, bool specular) {
    char defines[40];
    snprintf(defines, sizeof defines, "PACK %d;SPECULAR_BLUR %d", pack, specular);
    return program_init(
               &axis->program,
               &(struct program_desc){.screen = {"passes/gather/blur.frag"}, .defines = defines}) &&
           buffer_init(&axis->params, "blur parameters", sizeof(struct blur_params), NULL);
}

static bool init_pack(struct blur_pass *pass) {
    return program_init(&pass->pack_program,
                        &(struct program_desc){
                            .screen = {"passes/gather/blur_pack.frag"},
                            .defines = pass->desc.specular   ? "ADAPTIVE 0;SPECULAR_BLUR 1"
                                       : pass->desc.adaptive ? "ADAPTIVE 1;SPECULAR_BLUR 0"
                                                             : "ADAPTIVE 0;SPECULAR_BLUR 0",
                        });
}

static bool init_target(struct irradiance *target, const char *label, GLenum format,
                        const struct blur_desc *desc) {
    return irradiance_init(target, label, format, desc->width, desc->height, 1);
}

static bool init_taps(struct blur_pass *pass, const struct blur_desc *desc) {
    if (desc->lender) {
        pass->taps = desc->lender->taps;
        pass->half = desc->lender->half;
        pass->borrows = true;
        return true;
    }
    return init_target(&pass->taps, "blur taps", GL_RGBA32UI, desc) &&
           (desc->square || init_target(&pass->half, "blur taps", GL_RGBA32UI, desc));
}

/* 15 degrees. Smaller angles find no neighbours on small round objects; with one pixel to each side
 * the blur is as sharp as the lobe. */
static const float specular_cosine = .966F;

/* 5 degrees, for narrow lobes: a mirrored direction turns twice as far as the normal. */
static const float narrow_cosine = .996F;

struct blur_desc blur_desc_specular(int width, int height, int radius, float distance) {
    return (struct blur_desc){
        .width = width,
        .height = height,
        .radius = radius,
        .distance = distance,
        .cosine = specular_cosine,
        .detail_cosine = narrow_cosine,
        .specular = true,
        .level_radius = {.5F, (float)radius},
        .level_weight = {1, 1},
    };
}

bool blur_pass_init(struct blur_pass *pass, const struct blur_desc *desc) {
    *pass = (struct blur_pass){.desc = *desc};
    if (init_pack(pass) && init_taps(pass, desc) &&
        init_target(&pass->blurred, "blurred irradiance", GL_RGBA16F, desc) &&
        (desc->square || init_axis(&pass->along_x, true, false)) &&
        init_axis(&pass->along_y, false, desc->specular)) {
        pass->desc.lender = NULL;
        return true;
    }
    blur_pass_free(pass);
    return false;
}

static void free_axis(struct blur_axis *axis) {
    program_free(&axis->program);
    buffer_free(&axis->params);
}

void blur_pass_free(struct blur_pass *pass) {
    program_free(&pass->pack_program);
    free_axis(&pass->along_x);
    free_axis(&pass->along_y);
    if (!pass->borrows) {
        irradiance_free(&pass->taps);
        irradiance_free(&pass->half);
    }
    irradiance_free(&pass->blurred);
    *pass = (struct blur_pass){0};
}

/* Returns the radius within which other pixels take the light of list entries of this level: the
 * mean of both windows. By its own window a pixel would take light that does not come back. By
 * theirs, slots of the pattern would be missing, the same ones all along a slanted edge. Smooth
 * specular reflection is never blurred. */
static float taken_radius(const struct blur_desc *desc, int level) {
    float own = (float)desc->radius, theirs = desc->level_radius[level];
    return desc->specular ? fminf(own, theirs) : .5F * (own + theirs);
}

/* Returns the flux of all lights from which reflected light starts, W. */
static double light_power(const struct frame *frame) {
    double sum = 0;
    for (int i = 0; i < frame->emitters->count; i++)
        sum += emitter_flux(&frame->emitters->items[i], frame->geometry->radius);
    return sum;
}

static struct blur_params params_along(const struct blur_pass *pass,
                                       const struct irradiance *source, double power, bool y) {
    const struct blur_desc *desc = &pass->desc;
    float own = (float)desc->radius, edge = desc->level_radius[PIXEL_LEVEL_EDGE];
    return (struct blur_params){
        .pattern = irradiance_pattern(source),
        .along = {!y, y},
        .radius = desc->radius,
        .rows = desc->square ? desc->radius : 0,
        .distance = desc->distance,
        .cosine = desc->cosine,
        .detail_cosine = fmaxf(desc->cosine, desc->detail_cosine),
        .inverse_power = power > 0 ? (float)(1 / power) : 0,
        .radii = {own, edge, desc->level_radius[PIXEL_LEVEL_DETAIL], .5F * edge},
        .taken_radii = {own, taken_radius(desc, PIXEL_LEVEL_EDGE),
                        taken_radius(desc, PIXEL_LEVEL_DETAIL), edge},
        .weights = {1, desc->level_weight[PIXEL_LEVEL_EDGE], desc->level_weight[PIXEL_LEVEL_DETAIL],
                    desc->level_weight[PIXEL_LEVEL_EDGE]},
    };
}

static void write_params(const struct blur_pass *pass, const struct frame *frame,
                         const struct irradiance *source) {
    double power = (double)frame->irradiance_scale * light_power(frame);
    struct blur_params x = params_along(pass, source, power, false),
                       y = params_along(pass, source, power, true);
    buffer_write(&pass->along_y.params, 0, sizeof y, &y);
    if (!pass->desc.square)
        buffer_write(&pass->along_x.params, 0, sizeof x, &x);
}

static void add_surfaces(struct pass_state *state, const struct frame *frame,
                         const struct gbuffer *gbuffer, bool specular) {
    pass_add_texture(state, UNIT_GBUFFER_DEPTH, gbuffer->depth.id);
    pass_add_texture(state, UNIT_GBUFFER_NORMAL, gbuffer->normal.id);
    if (!specular)
        return;
    pass_add_texture(state, UNIT_GBUFFER_SPECULAR, gbuffer->specular.id);
    pass_add_texture(state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
}

static void pack(const struct blur_pass *pass, const struct frame *frame,
                 const struct gbuffer *gbuffer, const struct blur_inputs *inputs) {
    struct pass_state state = {
        .name = "blur",
        .program = pass->pack_program,
        .framebuffer = pass->taps.framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .textures = {{UNIT_IRRADIANCE, inputs->source->texture.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->along_y.params}},
    };
    add_surfaces(&state, frame, gbuffer, pass->desc.specular);
    if (inputs->lists) {
        pass_add_texture(&state, UNIT_LIST_TEXELS, inputs->lists->texels.id);
        pass_add_texture(&state, UNIT_ADAPTIVE_IRRADIANCE, inputs->adaptive->texture.id);
    }
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

static void blur_along(const struct blur_pass *pass, const struct frame *frame,
                       const struct gbuffer *gbuffer, const struct blur_axis *axis,
                       const struct irradiance *from, const struct irradiance *to) {
    struct pass_state state = {
        .name = "blur",
        .program = axis->program,
        .framebuffer = to->framebuffer,
        .width = pass->desc.width,
        .height = pass->desc.height,
        .textures = {{UNIT_BLUR_TAPS, from->texture.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &axis->params}},
    };
    if (pass->desc.specular && axis == &pass->along_y)
        add_surfaces(&state, frame, gbuffer, true);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

void blur_pass_render(const struct blur_pass *pass, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct blur_inputs *inputs) {
    timer_begin(frame->timers, "blur");
    write_params(pass, frame, inputs->source);
    pack(pass, frame, gbuffer, inputs);
    if (!pass->desc.square)
        blur_along(pass, frame, gbuffer, &pass->along_x, &pass->taps, &pass->half);
    blur_along(pass, frame, gbuffer, &pass->along_y, pass->desc.square ? &pass->taps : &pass->half,
               &pass->blurred);
    timer_end(frame->timers);
}

const struct irradiance *blur_pass_first(const struct blur_pass *pass, const struct frame *frame,
                                         const struct gbuffer *gbuffer,
                                         const struct irradiance *source) {
    if (frame->pass > 0)
        return source;
    blur_pass_render(pass, frame, gbuffer, &(struct blur_inputs){.source = source});
    return &pass->blurred;
}
