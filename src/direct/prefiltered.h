/* What methods have in common that look at windows of the lights' own maps: settings, summed area tables of
 * moments, bounds of depth. The state of such a method is a struct prefiltered. */
#ifndef DIRECT_PREFILTERED_H
#define DIRECT_PREFILTERED_H

#include "direct/shadow.h"
#include "passes/visibility/depth_bounds.h"
#include "passes/visibility/light_map.h"
#include "passes/visibility/sums.h"

extern const struct settings_part prefilter_part;

struct prefiltered {
    struct shadow shadow;
    struct light_map_pass light_maps;
    struct depth_bounds_pass bounds;
    struct sums_pass sums;
};

struct prefiltered_desc {
    int filter;                     /* FILTER_... of shared/lookup.h */
    int moments;                    /* 2 or 4 */
    int search_parts, shadow_parts; /* windows fall into so many cells a side */
};

/* For struct direct_method, with shadow_resize and shadow_light. */
bool prefiltered_init(void **state, const struct direct_desc *desc,
                      const struct prefiltered_desc *method);
void prefiltered_free(void *state);
void prefiltered_render_lights(void *state, const struct frame *frame);

#endif
