#include "direct/shadow.h"

#include <stdlib.h>

static const struct option table[] = {
    {"shadow-size", 0, OPTION_INT, offsetof(struct shadow_settings, size), 2048, 16, 16384,
     .label = "shadow texels",
     .help = "texels along each side of a light's shadow map;\n"
             "reduced for more than 32 lights or 21 point lights"},
    {NULL},
};

const struct settings_part shadow_part = {"direct", "shadow maps of direct light", table,
                                          sizeof(struct shadow_settings)};

/* Receiver offset along its normal, in texels of the map; pcss uses a sixth of it. */
static const float receiver_bias = 1.5F;

/* Half a GiB at most, of maps of 2048 texels. */
static int size_of(const struct direct_desc *desc) {
    const struct shadow_settings *own =
        settings_of(struct shadow_settings, desc->settings, &shadow_part);
    const int full_views = 32, faces_of_view = 4; /* which are half as large */
    const int *views = desc->lights->views;
    int count = views[LIGHT_MAP_SINGLE] + views[LIGHT_MAP_FACE] / faces_of_view;
    return light_map_share(own->size, count, full_views);
}

bool shadow_begin(struct shadow *shadow, const struct direct_desc *desc,
                  const struct direct_light_desc *program) {
    struct direct_light_desc light = *program;
    light.width = desc->width;
    light.height = desc->height;
    light.specular = desc->specular;
    light.medium = desc->medium;
    light.slides = desc->slides;
    light.map_size = program->map_size ? program->map_size : size_of(desc);
    light.bias = receiver_bias;
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        shadow->inputs.maps[kind] = &shadow->maps.maps[kind];
    return shadow_map_pass_init(&shadow->maps,
                                &(struct shadow_map_desc){size_of(desc), *desc->lights}) &&
           direct_light_pass_init(&shadow->light, &light);
}

void shadow_end(struct shadow *shadow) {
    shadow_map_pass_free(&shadow->maps);
    direct_light_pass_free(&shadow->light);
}

void shadow_free(void *state) {
    if (state)
        shadow_end(state);
    free(state);
}

bool shadow_resize(void *state, int width, int height) {
    struct shadow *shadow = state;
    return direct_light_pass_resize(&shadow->light, width, height);
}

void shadow_render_lights(void *state, const struct frame *frame) {
    struct shadow *shadow = state;
    shadow_map_pass_render(&shadow->maps, frame);
}

void shadow_render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct shadow *shadow = state;
    direct_light_pass_render(&shadow->light, frame, gbuffer, &shadow->inputs, DIRECT_LIGHT_ANEW);
}

const struct texture *shadow_specular(const void *state) {
    const struct shadow *shadow = state;
    return &shadow->light.target.specular;
}

const struct texture *shadow_light(const void *state) {
    const struct shadow *shadow = state;
    return &shadow->light.target.light;
}
