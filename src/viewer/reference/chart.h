/* Measures speed against accuracy of one view: a row for each preset and technique. */
#ifndef VIEWER_CHART_H
#define VIEWER_CHART_H

#include "renderer/renderer.h"

enum { CHART_MAX = 16 };

struct chart_row {
    char name[32];
    const struct technique *technique;
    struct settings settings;
    enum chart_state { ROW_WAITS, ROW_MEASURED, ROW_LEFT_OUT } state;
    double ms;
    struct image indirect; /* its indirect light of the view */
    bool has_error;
    double error;
};

struct chart {
    struct chart_row rows[CHART_MAX];
    int count;
    int next;          /* row to measure next; count: done */
    bool is_announced; /* the panel has named the next row, which may take a while */
};

/* Plans rows: presets of the default technique, other techniques, and the picture's own settings
 * if they are none of these. */
void chart_plan(struct chart *chart, const struct technique *technique,
                const struct settings *settings);
void chart_free(struct chart *chart);

/* Times frames of the next row and keeps the last. Leaves out settings that would take minutes.
 * Error: of a renderer; the row is left out. */
bool chart_measure_next(struct chart *chart, const struct renderer_desc *shown);

/* Returns the fastest row with a smaller error, or -1. */
int chart_cheapest(const struct chart *chart, double error);

#endif
