/* What methods have in common that look at windows of the lights' own maps: settings, bounds of depth, summed area
 * tables of moments. The state of such a method is a struct prefiltered, or begins with one. */
#ifndef DIRECT_PREFILTERED_H
#define DIRECT_PREFILTERED_H

#include "direct/shadow.h"
#include "passes/visibility/depth_bounds.h"
#include "passes/visibility/light_map.h"
#include "passes/visibility/sums.h"

extern const struct settings_part prefilter_part;

/* Those of a method that has no more to set than maps: prefilter_part and shadow_part. */
extern const struct settings_part *const prefilter_parts[];

struct prefiltered {
    struct shadow shadow;
    struct light_map_pass light_maps;
    struct depth_bounds_pass bounds;
    struct sums_pass sums; /* not where there are no moments */
};

struct prefiltered_desc {
    int filter;                     /* FILTER_... of shared/maps.h */
    int moments;                    /* 2 or 4; 0: none */
    int search_parts, shadow_parts; /* windows fall into so many cells a side */
    const char *defines;            /* more of them, each with a semicolon behind; or NULL */
    float shift, gain;              /* struct lookup_params' */
};

/* Error: as of the passes; prefiltered_end frees what is there. */
bool prefiltered_begin(struct prefiltered *own, const struct direct_desc *desc,
                       const struct prefiltered_desc *method);
void prefiltered_end(struct prefiltered *own);

/* For struct direct_method, with SHADOW_METHOD; the first two are for a state that is a struct prefiltered and no more. */
bool prefiltered_init(void **state, const struct direct_desc *desc,
                      const struct prefiltered_desc *method);
void prefiltered_free(void *state);
void prefiltered_render_lights(void *state, const struct frame *frame);

#endif
