/* Direct light with percentage-closer soft shadows [Fernando 2005]. */
#include "base/memory.h"
#include "direct/shadow.h"

#include <stdlib.h>

struct pcss_settings {
    int light_taps, search_taps, ways;
    float spread, nearest, plane_bias;
};

static const struct option table[] = {
    {"light-taps", 0, OPTION_INT, offsetof(struct pcss_settings, light_taps), 48, 1, 1024,
     .help = "points of a light that each pixel asks for"},
    {"search-taps", 0, OPTION_INT, offsetof(struct pcss_settings, search_taps), 48, 1, 1024,
     .help = "texels that it looks at to find what hides the light"},
    {"ways", 0, OPTION_INT, offsetof(struct pcss_settings, ways), 32, 0, 1024,
     .help = "points of a light to which it follows a way where casters lie at many distances"},
    {"spread", 0, OPTION_FLOAT, offsetof(struct pcss_settings, spread), .04, 0, 100,
     .help = "these do: the standard deviation of their distances, over the mean"},
    {"nearest", 0, OPTION_FLOAT, offsetof(struct pcss_settings, nearest), .2, .01, .99,
     .help = "where the search ends, of the receiver's distance from the light"},
    {"plane-bias", 0, OPTION_FLOAT, offsetof(struct pcss_settings, plane_bias), 1e-3, 0, .5,
     .help = "receiver offset towards the light, of its distance"},
    {NULL},
};

static const struct settings_part own_part = {"pcss", "direct light with soft shadows", table,
                                              sizeof(struct pcss_settings)};

static bool init(void **state, const struct direct_desc *desc) {
    const struct pcss_settings *own = settings_of(desc->settings, &own_part);
    struct shadow *shadow = *state = mem_alloc(1, sizeof *shadow);
    char *defines = mem_printf("FILTER_TAPS %d;SEARCH_TAPS %d;WAYS %d;SPREAD %.6f;NEAREST %.6f;",
                               own->light_taps, own->search_taps, own->ways, (double)own->spread,
                               (double)own->nearest);
    bool ok = shadow_begin(shadow, desc,
                           &(struct direct_light_desc){.map_bias = own->plane_bias,
                                                       .fragment = "direct/pcss/pcss.frag",
                                                       .defines = defines});
    free(defines);
    return ok;
}

static const struct settings_part *const parts[] = {&own_part, &shadow_part, NULL};

extern const struct direct_method pcss_direct;
const struct direct_method pcss_direct = {
    .name = "pcss",
    .help = "a shadow map for each light, soft shadows by its size",
    .parts = parts,
    .init = init,
    .free = shadow_free,
    .resize = shadow_resize,
    .render_lights = shadow_render_lights,
    .render_view = shadow_render_view,
    .light = shadow_light,
    .specular = shadow_specular,
};
