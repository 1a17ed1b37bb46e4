/* Instant radiosity with a hard paraboloid shadow map per VPL [Keller 1997; Dong 2009 §7, Fig. 10]:
 * the brute force that clustered visibility approximates; or with rays in place of maps. */
#include "base/memory.h"
#include "techniques/vpl_maps.h"

struct instant_radiosity_settings {
    bool traced; /* rays in place of maps */
};

/* Maps that are in memory at once. */
enum { MAP_BATCH = 64 };

static const struct option table[] = {
    {"traced", 0, OPTION_FLAG, offsetof(struct instant_radiosity_settings, traced), 0,
     .label = "traced shadows",
     .help = "shadow rays through all triangles instead of maps; with\n"
             "gather.interleave=1 or gather.adaptive=0, visibility is tested for 2 of\n"
             "every 12 VPLs (24 at 800x800) and 1 of every 16 near-field samples"},
    {NULL},
};

static const struct settings_part own_part = {"instant-radiosity", "a map per VPL", table,
                                              sizeof(struct instant_radiosity_settings)};

struct instant_radiosity {
    struct many_lights lights;
    bool traced; /* else: */
    struct paraboloid_pass paraboloid;
    struct vpl_maps maps;
};

static void free_state(void *state) {
    struct instant_radiosity *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        paraboloid_pass_free(&technique->paraboloid);
        vpl_maps_free(&technique->maps);
    }
    free(technique);
}

static bool init_traced(struct instant_radiosity *technique, const struct technique_desc *desc) {
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){VISIBILITY_LOOKUP_TRACED,
                                                             .map_per_vpl = true, .map_count = 1,
                                                             .together = true});
}

static bool init_maps(struct instant_radiosity *technique, const struct technique_desc *desc) {
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    int batch = MAP_BATCH < lights->vpls ? MAP_BATCH : lights->vpls;
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){VISIBILITY_LOOKUP_PLANE,
                                                             .map_per_vpl = true,
                                                             .map_count = batch}) &&
           vpl_maps_init_true(&technique->maps, &technique->paraboloid, desc, batch);
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct instant_radiosity_settings *own =
        settings_of(struct instant_radiosity_settings, desc->settings, &own_part);
    struct instant_radiosity *technique = *state = mem_alloc(1, sizeof *technique);
    technique->traced = own->traced;
    return own->traced ? init_traced(technique, desc) : init_maps(technique, desc);
}

static void render_lights(void *state, const struct frame *frame) {
    struct instant_radiosity *technique = state;
    if (technique->traced)
        many_lights_render_vpls(&technique->lights, frame);
    else
        vpl_maps_render_lights(&technique->maps, &technique->lights, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct instant_radiosity *technique = state;
    if (technique->traced)
        many_lights_render_view(&technique->lights, frame, gbuffer);
    else
        vpl_maps_render_view(&technique->maps, &technique->lights, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct instant_radiosity *technique = state;
    many_lights_outputs(&technique->lights, &technique->lights.vpls, outputs);
    if (technique->traced)
        return;
    output_add(outputs, &(struct output){"vpl-depth", "paraboloid depth maps of the last VPLs",
                                         OUTPUT_MAP_DEPTH, &technique->paraboloid.maps});
}

static const struct settings_part *const parts[] = {
    &lights_part, &own_part, &map_part, &caster_part, &gather_part, &blur_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "gather and blur as published", MANY_LIGHTS_AS_PUBLISHED, NULL},
    {NULL}};

extern const struct technique instant_radiosity_technique;
const struct technique instant_radiosity_technique = {
    .name = "instant-radiosity",
    .help = "a hard shadow map per VPL",
    MANY_LIGHTS_TECHNIQUE,
    .seeks_lights = true,
    .refinement = &many_lights_refinement,
    .check = many_lights_check,
    .resize = many_lights_resize,
};
