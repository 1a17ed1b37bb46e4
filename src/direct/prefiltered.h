/* Common parts of methods that filter windows of the lights' own maps: settings, depth bounds,
 * summed area tables of moments. The state of a method is a struct prefiltered or begins with
 * one. */
#ifndef DIRECT_PREFILTERED_H
#define DIRECT_PREFILTERED_H

#include "direct/shadow.h"
#include "passes/visibility/depth_bounds.h"
#include "passes/visibility/light_map.h"
#include "passes/visibility/sums.h"

extern const struct settings_part prefilter_part;

/* Parts of a method without other settings: prefilter_part and shadow_part. */
extern const struct settings_part *const prefilter_parts[];

struct prefiltered {
    struct shadow shadow;
    struct light_map_pass light_maps;
    struct depth_bounds_pass bounds;
    struct sums_pass sums; /* unused without moments */
};

struct prefiltered_desc {
    int filter;                     /* FILTER_... of shared/maps.h */
    int moments;                    /* 2 or 4; 0: none */
    int search_parts, shadow_parts; /* cells per side of a window */
    const char *defines;            /* further defines, each followed by a semicolon; or NULL */
    float shift, gain;              /* as in struct lookup_params */
};

/* Makes maps and passes. Error: as of the passes; call prefiltered_end then. */
bool prefiltered_begin(struct prefiltered *own, const struct direct_desc *desc,
                       const struct prefiltered_desc *method);
void prefiltered_end(struct prefiltered *own);

/* Members of a struct direct_method, with SHADOW_METHOD. The first two require a state that is
 * exactly a struct prefiltered. */
bool prefiltered_init(void **state, const struct direct_desc *desc,
                      const struct prefiltered_desc *method);
void prefiltered_free(void *state);
void prefiltered_render_lights(void *state, const struct frame *frame);

#endif
