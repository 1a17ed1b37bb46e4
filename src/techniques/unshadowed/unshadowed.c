/* Reflective shadow maps without visibility [Dachsbacher and Stamminger 2005]: what clustering has
 * to beat in accuracy, and is measured against in time. */
#include "base/memory.h"
#include "techniques/many_lights.h"

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

static void render_lights(void *state, const struct frame *frame) {
    many_lights_render_vpls(state, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    many_lights_render_view(state, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct many_lights *lights = state;
    many_lights_outputs(lights, &lights->vpls, outputs);
}

static const struct settings_part *const parts[] = {&lights_part, &gather_part, &blur_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "gather and blur as published", MANY_LIGHTS_AS_PUBLISHED, NULL},
    {NULL}};

/* Towards the unshadowed sum. */
static const struct refinement refinement = {"unshadowed", MANY_LIGHTS_REFINED, 2};

extern const struct technique unshadowed_technique;
const struct technique unshadowed_technique = {
    .name = "unshadowed",
    .help = "all VPLs, without visibility",
    MANY_LIGHTS_TECHNIQUE,
    .refinement = &refinement,
    .check = many_lights_check,
    .resize = many_lights_resize,
};
