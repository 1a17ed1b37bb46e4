/* Two pictures side by side at a wipe: another technique or other settings, or a reference from a
 * file; and how far apart they are. */
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
    float split;     /* where the right picture begins */
    bool only_right; /* toggled: the right picture alone */
    bool heat;       /* the errors as a map, in place of the left picture */
    int heat_metric; /* of metrics */
    bool flip; /* metrics that look at neighbourhoods, too: they follow when the picture has rested
                */

    /* COMPARE_TECHNIQUE: the right picture's own. */
    const struct technique *technique;
    struct settings settings;
    struct renderer other;
    bool has_other;

    struct reference reference; /* COMPARE_REFERENCE */

    /* Of the left picture against the right one, when it rested last. */
    bool measured;
    bool heat_drawn; /* and its map, or it will be when the metric has been measured */
    double values[METRIC_COUNT];
    bool is_known[METRIC_COUNT]; /* those that look at single pixels always are */
    struct measuring measuring;  /* the others */
    bool measures_again;         /* when what is measured, of an older picture, has ended */
    struct heat_map heat_scale;  /* without values */
    struct texture heat_map;
};

/* Accepts zeroed ones. */
void compare_free(struct compare *compare);

/* Lets the other renderer go: shaders or scene are no more what they were. */
void compare_forget(struct compare *compare);

/* Makes the other technique's renderer, or changes its settings; coarse: without antialiasing;
 * waits: as far as its technique and settings are what they were. Error: they are what they were,
 * or the comparison is off. */
bool compare_follow(struct compare *compare, const struct renderer *renderer, bool coarse,
                    bool waits);

/* Renders the other technique's picture of the same, after compare_follow, where it has a renderer.
 * Error: the comparison is then off. */
bool compare_render(struct compare *compare);

/* Makes the right picture show that layer, LAYER_..., and says which it is; NULL = none. */
const struct texture *compare_compose(struct compare *compare, const struct renderer *renderer,
                                      int layer);

/* Measures the errors, and draws the map; begins with the metrics of whole neighbourhoods where
 * those are wanted. wake: called from another thread when those are there, and
 * compare_follow_measuring is to take them. Error: the sizes differ, or a value is not finite. */
bool compare_measure(struct compare *compare, struct renderer *renderer, int layer,
                     void (*wake)(void));

/* Takes what has been measured; whether there was something. */
bool compare_follow_measuring(struct compare *compare);

#endif
