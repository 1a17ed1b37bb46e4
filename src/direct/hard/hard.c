/* Direct light with hard shadow maps [Dong 2009 §6].
 *
 * The lookup is that of other maps of depth (visibility/lookup.glsl), filtered over the four nearest
 * texels, so that the shadow's edge is a texel wide and not stepped. */
#include "base/memory.h"
#include "direct/direct.h"
#include "passes/visibility/direct_light.h"
#include "passes/visibility/shadow_map.h"
#include "shared/lookup.h"

#include <stdlib.h>

struct hard_settings {
    int shadow_size;
    float shadow_bias;
};

static const struct option table[] = {
    {"shadow-size", 0, OPTION_INT, offsetof(struct hard_settings, shadow_size), 2048, 16, 16384,
     .help = "shadow map of a light, texels a side"},
    {"shadow-bias", 0, OPTION_FLOAT, offsetof(struct hard_settings, shadow_bias), 1.5, 0, 100,
     .help = "receiver offset along its normal, in shadow texels"},
    {NULL},
};

static const struct settings_part own_part = {"hard", "direct light with hard shadows", table,
                                              sizeof(struct hard_settings)};

struct hard {
    struct shadow_map_pass shadow_map;
    struct direct_light_pass direct_light;
};

static void free_state(void *state) {
    struct hard *hard = state;
    if (hard) {
        shadow_map_pass_free(&hard->shadow_map);
        direct_light_pass_free(&hard->direct_light);
    }
    free(hard);
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct hard_settings *own = settings_of(desc->settings, &own_part);
    struct hard *hard = *state = mem_alloc(1, sizeof *hard);
    char *defines = mem_printf("FILTER %d;", FILTER_PCF);
    bool ok =
        shadow_map_pass_init(&hard->shadow_map,
                             &(struct shadow_map_desc){own->shadow_size, *desc->lights}) &&
        direct_light_pass_init(&hard->direct_light, &(struct direct_light_desc){
                                                        .width = desc->width,
                                                        .height = desc->height,
                                                        .map_size = own->shadow_size,
                                                        .bias = own->shadow_bias,
                                                        .fragment = "visibility/direct_point.frag",
                                                        .defines = defines,
                                                    });
    free(defines);
    return ok;
}

static bool resize(void *state, int width, int height) {
    struct hard *hard = state;
    return direct_light_pass_resize(&hard->direct_light, width, height);
}

static void render_lights(void *state, const struct frame *frame) {
    struct hard *hard = state;
    shadow_map_pass_render(&hard->shadow_map, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct hard *hard = state;
    direct_light_pass_render(&hard->direct_light, frame, gbuffer, hard->shadow_map.maps,
                             DIRECT_LIGHT_ANEW);
}

static const struct texture *light(const void *state) {
    const struct hard *hard = state;
    return &hard->direct_light.target.light;
}

static const struct settings_part *const parts[] = {&own_part, NULL};

extern const struct direct_method hard_direct;
const struct direct_method hard_direct = {
    .name = "hard",
    .help = "a shadow map for each light, hard shadows",
    .parts = parts,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .light = light,
};
