/* Reflective shadow maps without visibility [Dachsbacher and Stamminger 2005]: what clustering has
 * to beat in truth, and is measured against in time. */
#include "base/memory.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

static void free_state(void *state) {
    if (state)
        many_lights_free(state);
    free(state);
}

static bool init(void **state, const struct technique_desc *desc) {
    *state = mem_alloc(1, sizeof(struct many_lights));
    return many_lights_init(
        *state, desc, &(struct many_lights_visibility){VISIBILITY_LOOKUP_NONE, .map_count = 1});
}

static bool resize(void *state, int width, int height) {
    return many_lights_resize(state, width, height);
}

static void render_lights(void *state, const struct frame *frame) {
    many_lights_render_vpls(state, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct many_lights *lights = state;
    gather_pass_clear(&lights->gather);
    gather_pass_render(&lights->gather, frame, gbuffer,
                       &(struct gather_inputs){.vpls = &lights->vpls});
    many_lights_finish(lights, frame, gbuffer);
}

static void outputs(const void *state, struct technique_outputs *outputs) {
    many_lights_outputs(state, outputs);
}

extern const struct technique unshadowed_technique;
const struct technique unshadowed_technique = {
    .name = "unshadowed",
    .help = "all VPLs, no visibility",
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .outputs = outputs,
};
