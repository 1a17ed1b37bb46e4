/* Direct light with variance soft shadow maps [Dong 2011 ch. 7]. */
#include "direct/prefiltered.h"
#include "shared/lookup.h"

struct vssm_settings {
    int search_parts, shadow_parts;
};

static const struct option table[] = {
    {"search-parts", 0, OPTION_INT, offsetof(struct vssm_settings, search_parts), 5, 1, 16,
     .help = "parts a side of the window in which it seeks what hides the light"},
    {"shadow-parts", 0, OPTION_INT, offsetof(struct vssm_settings, shadow_parts), 8, 1, 16,
     .help = "and of the window of the penumbra"},
    {NULL},
};

static const struct settings_part own_part = {"vssm", "variance soft shadow maps", table,
                                              sizeof(struct vssm_settings)};

static bool init(void **state, const struct direct_desc *desc) {
    const struct vssm_settings *own = settings_of(desc->settings, &own_part);
    return prefiltered_init(state, desc,
                            &(struct prefiltered_desc){.filter = FILTER_VSSM,
                                                       .moments = 2,
                                                       .search_parts = own->search_parts,
                                                       .shadow_parts = own->shadow_parts});
}

static const struct settings_part *const parts[] = {&own_part, &prefilter_part, &shadow_part, NULL};

extern const struct direct_method vssm_direct;
const struct direct_method vssm_direct = {
    .name = "vssm",
    .help = "soft shadows from mean and variance of depth in windows",
    .parts = parts,
    .init = init,
    .free = prefiltered_free,
    .resize = shadow_resize,
    .render_lights = prefiltered_render_lights,
    .render_view = shadow_render_view,
    .light = shadow_light,
    .specular = shadow_specular,
};
