/* Clustered visibility [Dong 2009]: N VPLs light, and M virtual area lights with convolution soft
 * shadow maps say whether their light arrives. With visibility=hard the VAL's depth map is looked
 * up as it is: what the paper's soft shadows are compared with (§3). */
#include "base/memory.h"
#include "techniques/vals.h"

struct clustered {
    struct many_lights lights;
    bool by_rays; /* else: */
    struct vals vals;
};

static void free_state(void *state) {
    struct clustered *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        vals_free(&technique->vals);
    }
    free(technique);
}

static bool init_rays(struct clustered *technique, const struct technique_desc *desc) {
    return many_lights_init(
        &technique->lights, desc,
        &(struct many_lights_visibility){.lookup = VISIBILITY_LOOKUP_TRACED, .map_count = 1});
}

static bool init_maps(struct clustered *technique, const struct technique_desc *desc) {
    const struct val_set *first = &technique->vals.first;
    return vals_init(&technique->vals, desc, true) &&
           many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){
                                .lookup = vals_lookup(desc->settings),
                                .map_count = first->visibility.map_count,
                                .block = first->blocks.desc.block,
                            });
}

static bool init(void **state, const struct technique_desc *desc) {
    struct clustered *technique = *state = mem_alloc(1, sizeof *technique);
    technique->by_rays = vals_by_rays(desc->settings, desc->scene, desc->geometry);
    return (technique->by_rays ? init_rays : init_maps)(technique, desc);
}

static bool resize(void *state, int width, int height) {
    struct clustered *technique = state;
    return technique->by_rays ? many_lights_resize(&technique->lights, width, height)
                              : vals_resize(&technique->vals, &technique->lights, width, height);
}

static void render_lights(void *state, const struct frame *frame) {
    struct clustered *technique = state;
    many_lights_render_vpls(&technique->lights, frame);
    if (!technique->by_rays && !technique->vals.by_importance)
        vals_render(&technique->vals, &technique->lights, frame, NULL);
}

static void gather(struct clustered *technique, const struct val_set *vals, bool later,
                   const struct frame *frame, const struct gbuffer *gbuffer) {
    struct gather_inputs inputs = vals_render_blocks(vals, frame, gbuffer);
    inputs.later = later;
    many_lights_gather(&technique->lights, frame, gbuffer, &inputs);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct clustered *technique = state;
    if (technique->by_rays) {
        many_lights_render_view(&technique->lights, frame, gbuffer);
        return;
    }
    if (technique->vals.by_importance)
        vals_render(&technique->vals, &technique->lights, frame, gbuffer);
    many_lights_begin(&technique->lights, frame, gbuffer);
    gather(technique, &technique->vals.first, false, frame, gbuffer);
    if (technique->lights.bounces > 1)
        gather(technique, &technique->vals.later, true, frame, gbuffer);
    many_lights_finish(&technique->lights, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct clustered *technique = state;
    const struct many_lights *lights = &technique->lights;
    many_lights_outputs(
        lights, technique->by_rays ? &lights->vpls : &technique->vals.first.cluster.vpls, outputs);
    if (!technique->by_rays)
        vals_outputs(&technique->vals, outputs);
}

static const struct settings_part *const parts[] = {&lights_part, &vals_part,   &map_part,
                                                    &lookup_part, &caster_part, &gather_part,
                                                    &blur_part,   NULL};

static const struct preset presets[] = {
    {"draft", "for slow machines: 256 VPLs, no adaptive pixels",
     "lights.vpls=256 gather.adaptive=0", NULL},
    MANY_LIGHTS_FAST,
    {"traced", "1024 VPLs by rays, 256 of them at adaptive pixels: the least error of one frame",
     "clustered.trace=on lights.vpls=1024 gather.adaptive=2 gather.adaptive-factor=1", "high"},
    {"maps", "soft shadow maps of clusters instead of rays, for large scenes that move",
     "clustered.trace=off", NULL},
    {"paper", "as published: convolution soft shadow maps at each pixel and VPL",
     "clustered.trace=off clustered.visibility=cssm "
     "clustered.visibility-block=0 " MANY_LIGHTS_AS_PUBLISHED,
     NULL},
    {NULL}};

extern const struct technique clustered_technique;
const struct technique clustered_technique = {
    .name = "clustered",
    .help = "shadow rays, or soft shadow maps of clusters of VPLs",
    MANY_LIGHTS_TECHNIQUE,
    .seeks_lights = true,
    .refinement = &many_lights_refinement,
    .check = many_lights_check,
    .by_rays = vals_by_rays,
    .resize = resize,
};
