/* Measures speed against accuracy of one view: a dot for each preset and technique. */
#ifndef VIEWER_CHART_H
#define VIEWER_CHART_H

#include "renderer/renderer.h"

enum { CHART_MAX = 16 };

struct chart_dot {
    char name[32];
    const struct technique *technique;
    struct settings settings;
    enum chart_state { DOT_WAITS, DOT_MEASURED, DOT_LEFT_OUT } state;
    double ms;
    struct image indirect; /* its indirect light of the view */
    bool has_error;
    double error;
};

struct chart {
    struct chart_dot dots[CHART_MAX];
    int count;
    int next;          /* dot to measure next; count: done */
    bool is_announced; /* the panel has named the next dot, which may take a while */
};

/* Plans dots: presets of the default technique, other techniques, and the picture's own settings
 * if they are none of these. */
void chart_plan(struct chart *chart, const struct technique *technique,
                const struct settings *settings);
void chart_free(struct chart *chart);

/* Times frames of the next dot and keeps the last. Leaves out settings that would take minutes.
 * Error: of a renderer; the dot is left out. */
bool chart_measure_next(struct chart *chart, const struct renderer_desc *shown);

/* Returns the fastest dot with a smaller error, or -1. */
int chart_cheapest(const struct chart *chart, double error);

#endif
