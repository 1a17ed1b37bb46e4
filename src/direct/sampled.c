#include "direct/sampled.h"

#include "base/memory.h"
#include "direct/environment.h"
#include "passes/visibility/sampled_direct.h"

#include <stdlib.h>

struct sampled {
    struct sampled_direct_pass pass;
    const struct direct_method *others; /* of lights with maps, and the environment */
    void *others_state;
};

static void free_state(void *state) {
    struct sampled *sampled = state;
    if (sampled) {
        sampled_direct_pass_free(&sampled->pass);
        sampled->others->free(sampled->others_state);
    }
    free(sampled);
}

static bool init(void **state, const struct direct_desc *desc) {
    struct sampled *sampled = *state = mem_alloc(1, sizeof *sampled);
    sampled->others = desc->sky->count > 0 ? &environment_direct : desc->lamps;
    return sampled->others->init(&sampled->others_state, desc) &&
           sampled_direct_pass_init(&sampled->pass,
                                    &(struct sampled_direct_desc){.width = desc->width,
                                                                  .height = desc->height,
                                                                  .casters = desc->casters,
                                                                  .specular = desc->specular,
                                                                  .medium = desc->medium,
                                                                  .slides = desc->slides});
}

static bool resize(void *state, int width, int height) {
    struct sampled *sampled = state;
    const struct sampled_direct_desc old = sampled->pass.desc;
    if (!sampled_direct_pass_resize(&sampled->pass, width, height))
        return false;
    if (sampled->others->resize(sampled->others_state, width, height))
        return true;
    sampled_direct_pass_resize(&sampled->pass, old.width, old.height);
    return false;
}

static void render_lights(void *state, const struct frame *frame) {
    struct sampled *sampled = state;
    if (sampled->others->render_lights)
        sampled->others->render_lights(sampled->others_state, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct sampled *sampled = state;
    const struct direct_method *others = sampled->others;
    struct sampled_direct_inputs inputs = {.direct = others->light(sampled->others_state)};
    if (sampled->pass.desc.specular)
        inputs.specular = others->specular(sampled->others_state);
    others->render_view(sampled->others_state, frame, gbuffer);
    sampled_direct_pass_render(&sampled->pass, frame, gbuffer, &inputs);
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
