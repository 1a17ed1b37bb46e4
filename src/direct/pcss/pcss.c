/* Direct light with percentage-closer soft shadows [Fernando 2005]. */
#include "base/memory.h"
#include "direct/shadow.h"

#include <stdlib.h>

struct pcss_settings {
    int light_taps, shadow_rays;
};

static const struct option table[] = {
    {"light-taps", 0, OPTION_INT, offsetof(struct pcss_settings, light_taps), 48, 1, 1024,
     .label = "shadow samples",
     .help = "light samples per pixel; raise against steps in wide penumbrae"},
    {"shadow-rays", 0, OPTION_INT, offsetof(struct pcss_settings, shadow_rays), 32, 0, 1024,
     .label = "shadow rays",
     .help = "shadow rays per pixel through the map where blockers lie at\n"
             "many distances; raise against bands; 0: off"},
    {NULL},
};

static const struct settings_part own_part = {"pcss", "direct light with soft shadows", table,
                                              sizeof(struct pcss_settings)};

/* Where the search for blockers ends, over the receiver's distance from the light; and the receiver's offset towards the
 * light, over the same. */
static const double nearest = .2;
static const float plane_bias = 1e-3F;

enum { SEARCH_TAPS = 48 }; /* texels of the blocker search per pixel */

/* Standard deviation of the blockers' distances, over their mean, above which shadow rays act. */
static const double spread = .04;

static bool init(void **state, const struct direct_desc *desc) {
    const struct pcss_settings *own = settings_of(struct pcss_settings, desc->settings, &own_part);
    struct shadow *shadow = *state = mem_alloc(1, sizeof *shadow);
    char *defines = mem_printf("FILTER_TAPS %d;SEARCH_TAPS %d;WAYS %d;SPREAD %.6f;NEAREST %.6f;",
                               own->light_taps, SEARCH_TAPS, own->shadow_rays, spread, nearest);
    bool ok = shadow_begin(shadow, desc,
                           &(struct direct_light_desc){.map_bias = plane_bias,
                                                       .fragment = "direct/pcss/pcss.frag",
                                                       .defines = defines});
    free(defines);
    return ok;
}

static const struct settings_part *const parts[] = {&own_part, &shadow_part, NULL};

extern const struct direct_method pcss_direct;
const struct direct_method pcss_direct = {
    .name = "pcss",
    .help = "soft shadows by the light's size, one shadow map per light",
    .parts = parts,
    .init = init,
    .free = shadow_free,
    .render_lights = shadow_render_lights,
    .render_view = shadow_render_view,
    SHADOW_METHOD,
};
