/* Shows two pictures side by side at a wipe: another technique, other settings, or a reference
 * from a file. Measures their difference. */
#ifndef VIEWER_COMPARE_H
#define VIEWER_COMPARE_H

#include "metrics/heat_map.h"
#include "metrics/metric.h"
#include "renderer/renderer.h"
#include "viewer/picture/measuring.h"
#include "viewer/picture/reference.h"

enum compare_mode { COMPARE_OFF, COMPARE_TECHNIQUE, COMPARE_REFERENCE, COMPARE_MODES };

struct compare {
    enum compare_mode mode;
    float split;     /* fraction of the width where the right picture begins */
    bool only_right; /* show the right picture alone */
    bool heat;       /* show a map of errors in place of the left picture */
    int heat_metric; /* index into metrics */
    bool flip;       /* also measure metrics of neighbourhoods, once the picture rests */

    /* For COMPARE_TECHNIQUE: the right picture's own. */
    const struct technique *technique;
    struct settings settings;
    struct renderer other;
    bool has_other;

    struct reference reference; /* COMPARE_REFERENCE */

    /* Errors of the left picture against the right one, at its last rest. */
    bool measured;
    bool heat_drawn; /* the map is drawn, or will be once its metric is measured */
    double values[METRIC_COUNT];
    bool is_known[METRIC_COUNT]; /* always true for metrics of single pixels */
    struct measuring measuring;  /* metrics of neighbourhoods */
    bool measures_again;         /* begin again once the measuring of an older picture ends */
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

/* Measures the errors and draws the map. Starts the metrics of neighbourhoods if wanted; another
 * thread then calls `wake`, and compare_follow_measuring takes the results. Error: different
 * sizes, or a value that is not finite. */
bool compare_measure(struct compare *compare, struct renderer *renderer, int layer,
                     void (*wake)(void));

/* Takes new results of measuring. Returns true if there were any. */
bool compare_follow_measuring(struct compare *compare);

#endif
