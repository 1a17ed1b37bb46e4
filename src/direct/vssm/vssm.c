/* Direct light with variance soft shadow maps [Dong 2011 ch. 7]. */
#include "direct/prefiltered.h"
#include "shared/maps.h"

static bool init(void **state, const struct direct_desc *desc) {
    return prefiltered_init(
        state, desc,
        &(struct prefiltered_desc){
            .filter = FILTER_VSSM, .moments = 2, .search_parts = 5, .shadow_parts = 8});
}

extern const struct direct_method vssm_direct;
const struct direct_method vssm_direct = {
    .name = "vssm",
    .help = "soft shadows from mean and variance of depth in windows of the map",
    .parts = prefilter_parts,
    .init = init,
    .free = prefiltered_free,
    .render_lights = prefiltered_render_lights,
    .render_view = shadow_render_view,
    SHADOW_METHOD,
};
