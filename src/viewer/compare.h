/* Two pictures side by side at a wipe: another technique or other settings, or a reference from a
 * file; and how far apart they are. */
#ifndef VIEWER_COMPARE_H
#define VIEWER_COMPARE_H

#include "metrics/heat_map.h"
#include "metrics/metric.h"
#include "renderer/renderer.h"
#include "viewer/reference.h"

enum compare_mode { COMPARE_OFF, COMPARE_TECHNIQUE, COMPARE_REFERENCE, COMPARE_MODES };

struct compare {
    enum compare_mode mode;
    float split;     /* where the right picture begins */
    bool only_right; /* toggled: the right picture alone */
    bool heat;       /* the errors as a map, in place of the left picture */
    int heat_metric; /* of metrics */

    /* COMPARE_TECHNIQUE: the right picture's own. */
    const struct technique *technique;
    struct settings settings;
    struct renderer other;
    bool has_other;

    struct reference reference; /* COMPARE_REFERENCE */

    /* Of the left picture against the right one, when it rested last. */
    bool measured;
    double values[METRIC_COUNT];
    bool is_known[METRIC_COUNT]; /* those that look at single pixels always are */
    struct heat_map heat_scale;  /* without values */
    struct texture heat_map;
};

/* Accepts zeroed ones. */
void compare_free(struct compare *compare);

/* Lets the other renderer go: shaders or scene are no more what they were. */
void compare_forget(struct compare *compare);

/* Makes the other technique's renderer, or changes its settings; coarse: without antialiasing.
 * Error: they are what they were, or the comparison is off. */
bool compare_follow(struct compare *compare, const struct renderer *renderer, bool coarse);

/* Renders the other technique's picture of the same, after
 * compare_follow. Error: the comparison is then off. */
bool compare_render(struct compare *compare);

/* Makes the right picture show that layer, LAYER_..., and says which it is; NULL = none. */
const struct texture *compare_compose(struct compare *compare, const struct renderer *renderer,
                                      int layer);

/* Measures the errors, with metrics of whole neighbourhoods (FLIP) if asked to, and draws the map.
 * Error: the sizes differ, or a value is not finite. */
bool compare_measure(struct compare *compare, struct renderer *renderer, int layer, bool all);

#endif
