/* Shows two pictures side by side at a wipe: another technique, other settings, or a reference
 * from a file. Measures their difference. */
#ifndef VIEWER_COMPARE_H
#define VIEWER_COMPARE_H

#include "metrics/heat_map.h"
#include "metrics/metric.h"
#include "renderer/renderer.h"
#include "viewer/picture/reference.h"

enum compare_mode { COMPARE_OFF, COMPARE_TECHNIQUE, COMPARE_REFERENCE, COMPARE_MODES };

struct compare {
    enum compare_mode mode;
    float split;     /* fraction of the width where the right picture begins */
    bool only_right; /* show the right picture alone */
    bool heat;       /* show a map of errors in place of the left picture */
    int heat_metric; /* index into metrics */

    /* For COMPARE_TECHNIQUE: the right picture's own. */
    const struct technique *technique;
    struct settings settings;
    struct renderer other;
    bool has_other;

    struct reference reference; /* COMPARE_REFERENCE */

    /* Errors of the left picture against the right one, at its last rest. */
    bool measured;
    bool has_values; /* false: they could not be measured */
    bool heat_drawn;
    double values[METRIC_COUNT]; /* only of metrics with compare_has_metric */
    struct heat_map heat_scale;  /* scale without values */
    struct texture heat_map;
};

/* Frees everything. Accepts a zeroed struct. */
void compare_free(struct compare *compare);

/* Frees the other renderer, because shaders or scene have changed. */
void compare_forget(struct compare *compare);

/* Makes or updates the other technique's renderer. coarse: without antialiasing. waits: keeps
 * its technique and settings. Error: they stay as before, or the comparison is switched off. */
bool compare_follow(struct compare *compare, const struct renderer *renderer, bool coarse,
                    bool waits);

/* Renders the other technique's picture, if it has a renderer. Call it after compare_follow.
 * Error: the comparison is switched off. */
bool compare_render(struct compare *compare);

/* Composes the right picture's layer (LAYER_...) and returns it. NULL: none. */
const struct texture *compare_compose(struct compare *compare, const struct renderer *renderer,
                                      int layer);

/* Returns true for metrics of single pixels: those of neighbourhoods, such as FLIP, take too long
 * here. */
bool compare_has_metric(int metric);

/* Measures the errors and draws the map. Error: different sizes, or a value that is not finite. */
bool compare_measure(struct compare *compare, struct renderer *renderer, int layer);

#endif
