/* Direct light with percentage-closer soft shadows [Fernando 2005]. */
#include "base/memory.h"
#include "direct/shadow.h"
#include "shared/bindings.h"

struct pcss_settings {
    int light_taps, shadow_rays;
};

static const struct option table[] = {
    {"light-taps", 0, OPTION_INT, offsetof(struct pcss_settings, light_taps), 48, 1, 1024,
     .label = "shadow samples",
     .help = "texels of the map per pixel where no rays are traced;\n"
             "raise against steps in wide penumbrae"},
    {"shadow-rays", 0, OPTION_INT, offsetof(struct pcss_settings, shadow_rays), 64, 0, 1024,
     .label = "shadow rays",
     .help = "shadow rays per pixel where the map has something in front of the light;\n"
             "raise against bands; 0: by the map alone, as in large scenes that move"},
    {NULL},
};

static const struct settings_part own_part = {"pcss", "direct light with soft shadows", table,
                                              sizeof(struct pcss_settings)};

/* Where the search for blockers ends, over the receiver's distance from the light; and the
 * receiver's offset towards the light, over the same. */
static const double nearest = .2;
static const float plane_bias = 1e-3F;

enum { SEARCH_TAPS = 48 }; /* texels of the blocker search per pixel */

struct pcss {
    struct shadow shadow; /* first: shadow_render_lights and others take the state for it */
    struct caster_pool *casters;
    const struct caster_bvh *tree; /* NULL: the maps answer alone */
};

static void free_state(void *state) {
    struct pcss *pcss = state;
    if (pcss) {
        caster_pool_release_tree(pcss->casters, &pcss->tree);
        shadow_end(&pcss->shadow);
    }
    free(pcss);
}

static bool init(void **state, const struct direct_desc *desc) {
    const struct pcss_settings *own = settings_of(struct pcss_settings, desc->settings, &own_part);
    struct pcss *pcss = *state = mem_alloc(1, sizeof *pcss);
    bool by_rays = desc->may_trace && own->shadow_rays > 0;
    char *defines =
        mem_printf("FILTER_TAPS %d;SEARCH_TAPS %d;SHADOW_RAYS %d;NEAREST %.6f;", own->light_taps,
                   SEARCH_TAPS, by_rays ? own->shadow_rays : 0, nearest);
    pcss->casters = desc->casters;
    bool ok = (!by_rays || caster_pool_acquire_tree(desc->casters, &pcss->tree)) &&
              shadow_begin(&pcss->shadow, desc,
                           &(struct direct_light_desc){.map_bias = plane_bias,
                                                       .fragment = "direct/pcss/pcss.frag",
                                                       .defines = defines});
    free(defines);
    return ok;
}

/* A BVH that has grown is in another texture. */
static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct pcss *pcss = state;
    if (pcss->tree)
        pcss->shadow.inputs.more[0] = (struct pass_texture){UNIT_BVH, pcss->tree->buffer.texels};
    shadow_render_view(state, frame, gbuffer);
}

static const struct settings_part *const parts[] = {&own_part, &shadow_part, NULL};

extern const struct direct_method pcss_direct;
const struct direct_method pcss_direct = {
    .name = "pcss",
    .help = "soft shadows by the light's size, one shadow map per light",
    .parts = parts,
    .init = init,
    .free = free_state,
    .render_lights = shadow_render_lights,
    .render_view = render_view,
    SHADOW_METHOD,
};
