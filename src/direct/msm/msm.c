/* Direct light with moment soft shadow maps [Peters and Klein 2015; Peters et al. 2017]. */
#include "direct/prefiltered.h"
#include "shared/maps.h"

static bool init(void **state, const struct direct_desc *desc) {
    return prefiltered_init(
        state, desc,
        &(struct prefiltered_desc){
            .filter = FILTER_MSM, .moments = 4, .search_parts = 3, .shadow_parts = 3});
}

extern const struct direct_method msm_direct;
const struct direct_method msm_direct = {
    .name = "msm",
    .help = "soft shadows from four moments of depth in windows of the map",
    .parts = prefilter_parts,
    .init = init,
    .free = prefiltered_free,
    .render_lights = prefiltered_render_lights,
    .render_view = shadow_render_view,
    SHADOW_METHOD,
};
