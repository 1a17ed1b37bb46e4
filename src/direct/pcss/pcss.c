/* Direct light with percentage-closer soft shadows [Fernando 2005]. */
#include "base/memory.h"
#include "direct/direct.h"
#include "direct/shadow.h"
#include "passes/visibility/direct_light.h"
#include "passes/visibility/shadow_map.h"

#include <stdlib.h>

struct pcss_settings {
    int light_taps, search_taps;
    float nearest, plane_bias;
};

static const struct option table[] = {
    {"light-taps", 0, OPTION_INT, offsetof(struct pcss_settings, light_taps), 48, 1, 1024,
     .help = "points of a light that each pixel asks for"},
    {"search-taps", 0, OPTION_INT, offsetof(struct pcss_settings, search_taps), 48, 1, 1024,
     .help = "texels that it looks at to find what hides the light"},
    {"nearest", 0, OPTION_FLOAT, offsetof(struct pcss_settings, nearest), .2, .01, .99,
     .help = "where the search ends, of the receiver's distance from the light"},
    {"plane-bias", 0, OPTION_FLOAT, offsetof(struct pcss_settings, plane_bias), 1e-3, 0, .5,
     .help = "receiver offset towards the light, of its distance"},
    {NULL},
};

static const struct settings_part own_part = {"pcss", "direct light with soft shadows", table,
                                              sizeof(struct pcss_settings)};

struct pcss {
    struct shadow_map_pass shadow_map;
    struct direct_light_pass direct_light;
};

static void free_state(void *state) {
    struct pcss *pcss = state;
    if (pcss) {
        shadow_map_pass_free(&pcss->shadow_map);
        direct_light_pass_free(&pcss->direct_light);
    }
    free(pcss);
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct pcss_settings *own = settings_of(desc->settings, &own_part);
    const struct shadow_settings *shadow = settings_of(desc->settings, &shadow_part);
    struct pcss *pcss = *state = mem_alloc(1, sizeof *pcss);
    char *defines = mem_printf("FILTER_TAPS %d;SEARCH_TAPS %d;NEAREST %.6f;", own->light_taps,
                               own->search_taps, (double)own->nearest);
    bool ok = shadow_map_pass_init(&pcss->shadow_map,
                                   &(struct shadow_map_desc){shadow->size, *desc->lights}) &&
              direct_light_pass_init(&pcss->direct_light, &(struct direct_light_desc){
                                                              .width = desc->width,
                                                              .height = desc->height,
                                                              .map_size = shadow->size,
                                                              .bias = shadow->bias,
                                                              .map_bias = own->plane_bias,
                                                              .fragment = "direct/pcss/pcss.frag",
                                                              .defines = defines,
                                                          });
    free(defines);
    return ok;
}

static bool resize(void *state, int width, int height) {
    struct pcss *pcss = state;
    return direct_light_pass_resize(&pcss->direct_light, width, height);
}

static void render_lights(void *state, const struct frame *frame) {
    struct pcss *pcss = state;
    shadow_map_pass_render(&pcss->shadow_map, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct pcss *pcss = state;
    direct_light_pass_render(&pcss->direct_light, frame, gbuffer, pcss->shadow_map.maps,
                             DIRECT_LIGHT_ANEW);
}

static const struct texture *light(const void *state) {
    const struct pcss *pcss = state;
    return &pcss->direct_light.target.light;
}

static const struct settings_part *const parts[] = {&own_part, &shadow_part, NULL};

extern const struct direct_method pcss_direct;
const struct direct_method pcss_direct = {
    .name = "pcss",
    .help = "a shadow map for each light, soft shadows by its size",
    .parts = parts,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .light = light,
};
