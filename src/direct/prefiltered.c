#include "direct/prefiltered.h"

#include "base/memory.h"

struct prefilter_settings {
    int size;
};

static const struct option table[] = {
    {"texels", 0, OPTION_INT, offsetof(struct prefilter_settings, size), 1024, 16, 4096,
     .label = "map texels",
     .help = "texels along each side of a light's own map; a point\n"
             "light has 6 maps, a light of a half space 1, whose middle\n"
             "half covers 90 degrees; reduced for more than 24 maps"},
    {NULL},
};

const struct settings_part prefilter_part = {"prefilter",
                                             "prefiltered maps of lights (cssm, msm, vssm)", table,
                                             sizeof(struct prefilter_settings)};

const struct settings_part *const prefilter_parts[] = {&prefilter_part, &shadow_part, NULL};

static bool init_maps(struct prefiltered *own, int size, const struct light_layout *lights,
                      int moments) {
    return light_map_pass_init(&own->light_maps, size, lights) &&
           depth_bounds_pass_init(&own->bounds, size, lights->maps) &&
           (moments == 0 || sums_pass_init(&own->sums, &(struct sums_desc){.size = size,
                                                                           .count = lights->maps,
                                                                           .moments = moments}));
}

static void show_maps(struct prefiltered *own) {
    struct direct_light_inputs *inputs = &own->shadow.inputs;
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        inputs->maps[kind] = &own->light_maps.maps.depth;
    inputs->more[0] = (struct pass_texture){UNIT_DEPTH_BOUNDS, own->bounds.maps.bounds.id};
    inputs->more[1] = (struct pass_texture){UNIT_SUMS, own->sums.maps.sums.id};
}

/* Three quarters of a GiB at most, of maps of 1024 texels with sums of four moments. */
static int size_of(const struct direct_desc *desc) {
    const struct prefilter_settings *set =
        settings_of(struct prefilter_settings, desc->settings, &prefilter_part);
    const int full_maps = 24;
    return light_map_share(set->size, desc->lights->maps, full_maps);
}

/* Of the receiver towards the light, over its distance. */
static const float depth_bias = 2e-3F;

/* Between caster and receiver, over the receiver's distance from the light: nearer texels are
 * compared one by one. */
static const float contact = .01F;

bool prefiltered_begin(struct prefiltered *own, const struct direct_desc *desc,
                       const struct prefiltered_desc *method) {
    char *defines = mem_printf("%sFILTER %d;SEARCH_PARTS %d;SHADOW_PARTS %d;",
                               method->defines ? method->defines : "", method->filter,
                               method->search_parts, method->shadow_parts);
    bool ok = shadow_begin(&own->shadow, desc,
                           &(struct direct_light_desc){.map_size = size_of(desc),
                                                       .own_maps = true,
                                                       .map_bias = depth_bias,
                                                       .contact = contact,
                                                       .shift = method->shift,
                                                       .gain = method->gain,
                                                       .fragment = "passes/visibility/direct.frag",
                                                       .defines = defines}) &&
              init_maps(own, size_of(desc), desc->lights, method->moments);
    free(defines);
    if (ok)
        show_maps(own);
    return ok;
}

bool prefiltered_init(void **state, const struct direct_desc *desc,
                      const struct prefiltered_desc *method) {
    *state = mem_alloc(1, sizeof(struct prefiltered));
    return prefiltered_begin(*state, desc, method);
}

void prefiltered_end(struct prefiltered *own) {
    shadow_end(&own->shadow);
    light_map_pass_free(&own->light_maps);
    depth_bounds_pass_free(&own->bounds);
    sums_pass_free(&own->sums);
}

void prefiltered_free(void *state) {
    if (state)
        prefiltered_end(state);
    free(state);
}

void prefiltered_render_lights(void *state, const struct frame *frame) {
    struct prefiltered *own = state;
    const struct texture *depth = &own->light_maps.maps.depth;
    shadow_render_lights(&own->shadow, frame);
    light_map_pass_render(&own->light_maps, frame, own->shadow.maps.maps);
    depth_bounds_pass_render(&own->bounds, frame, depth);
    if (own->sums.maps.count)
        sums_pass_render(&own->sums, frame, depth, NULL);
}
