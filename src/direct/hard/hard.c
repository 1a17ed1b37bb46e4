/* Direct light with hard shadow maps [Dong 2009 §6].
 *
 * The lookup is that of other maps of depth (visibility/lookup.glsl), filtered over the four nearest
 * texels, so that the shadow's edge is a texel wide and not stepped. */
#include "base/memory.h"
#include "direct/direct.h"
#include "direct/shadow.h"
#include "passes/visibility/direct_light.h"
#include "passes/visibility/shadow_map.h"
#include "shared/lookup.h"

#include <stdlib.h>

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
    const struct shadow_settings *shadow = settings_of(desc->settings, &shadow_part);
    struct hard *hard = *state = mem_alloc(1, sizeof *hard);
    char *defines =
        mem_printf("FILTER %d;%s", FILTER_PCF, desc->lights->sized ? "" : "POINTS_ONLY;");
    bool ok =
        shadow_map_pass_init(&hard->shadow_map,
                             &(struct shadow_map_desc){shadow->size, *desc->lights}) &&
        direct_light_pass_init(&hard->direct_light, &(struct direct_light_desc){
                                                        .width = desc->width,
                                                        .height = desc->height,
                                                        .map_size = shadow->size,
                                                        .bias = shadow->bias,
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

static const struct settings_part *const parts[] = {&shadow_part, NULL};

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
