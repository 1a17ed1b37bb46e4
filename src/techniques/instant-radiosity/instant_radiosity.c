/* Instant radiosity with a hard paraboloid shadow map per VPL [Keller 1997; Dong 2009 §7, Fig. 10]:
 * the brute force that clustered visibility approximates. Maps are drawn in batches, so that N is
 * bounded by time and not by memory. */
#include "base/memory.h"
#include "passes/visibility/paraboloid.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

struct instant_radiosity_settings {
    int map_batch; /* maps in memory at once */
};

static const struct option table[] = {
    {"map-batch", 0, OPTION_INT, offsetof(struct instant_radiosity_settings, map_batch), 64, 1,
     1024, .help = "maps in memory at once"},
    {NULL},
};

static const struct settings_part own_part = {"instant-radiosity", "a map per VPL", table,
                                              sizeof(struct instant_radiosity_settings)};

struct instant_radiosity {
    struct many_lights lights;
    struct paraboloid_pass paraboloid;
};

static void free_state(void *state) {
    struct instant_radiosity *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        paraboloid_pass_free(&technique->paraboloid);
    }
    free(technique);
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct instant_radiosity_settings *own = settings_of(desc->settings, &own_part);
    const struct lights_settings *lights = settings_of(desc->settings, &lights_part);
    const struct map_settings *map = settings_of(desc->settings, &map_part);
    struct instant_radiosity *technique = *state = mem_alloc(1, sizeof *technique);
    /* Every triangle: what the technique is for is the plain truth. */
    struct caster_desc caster = many_lights_caster(desc->settings);
    caster.error = 0;
    int batch = own->map_batch < lights->vpls ? own->map_batch : lights->vpls;
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){VISIBILITY_LOOKUP_PLANE,
                                                             .map_per_vpl = true,
                                                             .map_count = batch}) &&
           paraboloid_pass_init(&technique->paraboloid,
                                &(struct paraboloid_desc){
                                    .casters = desc->casters,
                                    .caster = caster,
                                    .bend = many_lights_caster_bend(desc->settings),
                                    .size = map->size,
                                    .count = batch,
                                    .planes = true,
                                    .near_clip = map->near_clip,
                                });
}

static bool resize(void *state, int width, int height) {
    struct instant_radiosity *technique = state;
    return many_lights_resize(&technique->lights, width, height);
}

/* The maps of a batch of VPLs: only one batch is kept. Returns how many they are; 0 after the last.
 */
static int render_batch(struct instant_radiosity *technique, const struct frame *frame,
                        const struct vpl_buffer *vpls, int first) {
    struct paraboloid_pass *paraboloid = &technique->paraboloid;
    int rest = vpls->count - first, batch = paraboloid->desc.count;
    int count = rest < batch ? rest : batch;
    if (count > 0) {
        paraboloid_pass_view_vpls(paraboloid, frame, vpls, first, count);
        paraboloid_pass_render(paraboloid, frame, &paraboloid->views);
    }
    return count;
}

static struct visibility_inputs batch_maps(const struct instant_radiosity *technique) {
    return (struct visibility_inputs){.views = &technique->paraboloid.views,
                                      .depth = &technique->paraboloid.maps};
}

static void render_bounce(struct instant_radiosity *technique, const struct frame *frame,
                          int bounce) {
    struct many_lights *lights = &technique->lights;
    const struct vpl_buffer *vpls = bounce == 2 ? &lights->vpls : &lights->bounce.vpls;
    bounce_pass_begin(&lights->bounce);
    for (int first = 0, count; (count = render_batch(technique, frame, vpls, first)) > 0;
         first += count) {
        struct bounce_inputs inputs = {vpls, first, count, batch_maps(technique)};
        if (bounce == 2 && first == 0)
            bounce_pass_pick(&lights->bounce, frame, &inputs);
        bounce_pass_gather(&lights->bounce, frame, &inputs);
    }
    many_lights_end_bounce(lights, frame, bounce);
}

static void render_lights(void *state, const struct frame *frame) {
    struct instant_radiosity *technique = state;
    many_lights_render_vpls(&technique->lights, frame);
    for (int bounce = 2; bounce <= technique->lights.bounces; bounce++)
        render_bounce(technique, frame, bounce);
}

static void gather(struct instant_radiosity *technique, const struct vpl_buffer *vpls, bool further,
                   const struct frame *frame, const struct gbuffer *gbuffer) {
    for (int first = 0, count; (count = render_batch(technique, frame, vpls, first)) > 0;
         first += count)
        many_lights_gather(&technique->lights, frame, gbuffer,
                           &(struct gather_inputs){.vpls = vpls,
                                                   .first = first,
                                                   .count = count,
                                                   .further = further,
                                                   .visibility = batch_maps(technique)});
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct instant_radiosity *technique = state;
    struct many_lights *lights = &technique->lights;
    many_lights_begin(lights, frame, gbuffer);
    gather(technique, &lights->vpls, false, frame, gbuffer);
    if (lights->bounces > 1)
        gather(technique, &lights->bounce.vpls, true, frame, gbuffer);
    many_lights_finish(lights, frame, gbuffer);
}

static struct contribution contribution(const void *state) {
    const struct instant_radiosity *technique = state;
    return many_lights_contribution(&technique->lights);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct instant_radiosity *technique = state;
    many_lights_outputs(&technique->lights, &technique->lights.vpls, outputs);
    output_add(outputs, &(struct output){"vpl-depth", "paraboloid depth maps of the last VPLs",
                                         OUTPUT_MAP_DEPTH, &technique->paraboloid.maps});
}

static const struct settings_part *const parts[] = {
    &lights_part, &own_part, &map_part, &lookup_part, &caster_part, &gather_part, &blur_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST, {"paper", "gather and blur as published", MANY_LIGHTS_AS_PUBLISHED}, {NULL}};

extern const struct technique instant_radiosity_technique;
const struct technique instant_radiosity_technique = {
    .name = "instant-radiosity",
    .help = "a hard shadow map per VPL",
    .parts = parts,
    .presets = presets,
    .refinement = &many_lights_refinement,
    .check = many_lights_check,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .contribution = contribution,
    .outputs = outputs,
};
