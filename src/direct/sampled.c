#include "direct/sampled.h"

#include "base/memory.h"
#include "direct/environment.h"
#include "passes/frame.h"
#include "passes/gather/blur.h"
#include "passes/visibility/sampled_direct.h"

/* Neighbours of a pixel, as the blurs of indirect light have them (techniques/many_lights.h). */
static const float distance = .1F, cosine = .995F;

struct sampled {
    struct sampled_direct_pass pass;
    struct blur_pass blur, specular_blur;
    const struct direct_method *others; /* of lights with maps, and the environment */
    void *others_state;
};

static void free_blurs(struct sampled *sampled) {
    blur_pass_free(&sampled->specular_blur);
    blur_pass_free(&sampled->blur);
}

static bool init_blurs(struct sampled *sampled, int width, int height) {
    struct blur_desc blur = {.width = width,
                             .height = height,
                             .radius = SAMPLED_DIRECT_RADIUS,
                             .distance = distance,
                             .cosine = cosine},
                     specular = blur_desc_specular(width, height, SAMPLED_DIRECT_RADIUS, distance);
    specular.lender = &sampled->blur;
    return blur_pass_init(&sampled->blur, &blur) &&
           (!sampled->pass.desc.specular || blur_pass_init(&sampled->specular_blur, &specular));
}

static void free_state(void *state) {
    struct sampled *sampled = state;
    if (sampled) {
        sampled_direct_pass_free(&sampled->pass);
        free_blurs(sampled);
        sampled->others->free(sampled->others_state);
    }
    free(sampled);
}

static bool init(void **state, const struct direct_desc *desc) {
    struct sampled *sampled = *state = mem_alloc(1, sizeof *sampled);
    const struct sampled_direct_desc pass = {.width = desc->width,
                                             .height = desc->height,
                                             .distance = distance,
                                             .cosine = cosine,
                                             .casters = desc->casters,
                                             .specular = desc->specular,
                                             .medium = desc->medium,
                                             .slides = desc->slides};
    sampled->others = desc->sky->count > 0 ? &environment_direct : desc->lamps;
    return sampled->others->init(&sampled->others_state, desc) &&
           sampled_direct_pass_init(&sampled->pass, &pass) &&
           init_blurs(sampled, desc->width, desc->height);
}

/* The blurs of the new size are made first: they go where another part cannot take it. */
static bool resize(void *state, int width, int height) {
    struct sampled *sampled = state, fresh = *sampled;
    const struct sampled_direct_desc old = sampled->pass.desc;
    fresh.blur = fresh.specular_blur = (struct blur_pass){0};
    bool made = init_blurs(&fresh, width, height) &&
                sampled_direct_pass_resize(&sampled->pass, width, height);
    bool ok = made && sampled->others->resize(sampled->others_state, width, height);
    if (made && !ok)
        sampled_direct_pass_resize(&sampled->pass, old.width, old.height);
    free_blurs(ok ? sampled : &fresh);
    if (ok) {
        sampled->blur = fresh.blur;
        sampled->specular_blur = fresh.specular_blur;
    }
    return ok;
}

static void render_lights(void *state, const struct frame *frame) {
    struct sampled *sampled = state;
    if (sampled->others->render_lights)
        sampled->others->render_lights(sampled->others_state, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct sampled *sampled = state;
    const struct direct_method *others = sampled->others;
    const struct sampled_direct_pass *pass = &sampled->pass;
    others->render_view(sampled->others_state, frame, gbuffer);
    sampled_direct_pass_render(pass, frame, gbuffer);
    struct sampled_direct_inputs inputs = {
        .direct = others->light(sampled->others_state),
        .irradiance = blur_pass_first(&sampled->blur, frame, gbuffer, &pass->irradiance)};
    if (pass->desc.specular) {
        inputs.specular = others->specular(sampled->others_state);
        inputs.radiance = blur_pass_first(&sampled->specular_blur, frame, gbuffer, &pass->radiance);
    }
    sampled_direct_pass_add(pass, frame, &inputs);
}

static const struct texture *light(const void *state) {
    const struct sampled *sampled = state;
    return &sampled->pass.light;
}

static const struct texture *specular(const void *state) {
    const struct sampled *sampled = state;
    return &sampled->pass.specular;
}

const struct direct_method sampled_direct = {
    .name = "sampled",
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .light = light,
    .specular = specular,
};
