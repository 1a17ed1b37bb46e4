/* Speed against accuracy of one view: a dot for each preset and technique. */
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
    struct image indirect; /* what it makes of the view */
    bool has_error;
    double error;
};

struct chart {
    struct chart_dot dots[CHART_MAX];
    int count;
    int next;          /* to be measured; count: all are */
    bool is_announced; /* the panel has shown which is next: it may take a while */
};

/* All presets of the default technique, every other technique, and those of the picture, where they
 * are none of them. */
void chart_plan(struct chart *chart, const struct technique *technique,
                const struct settings *settings);
void chart_free(struct chart *chart);

/* Times the next dot's frames and keeps the last. Settings that would take minutes here are left
 * out. Error: of a renderer; the dot is left out. */
bool chart_measure_next(struct chart *chart, const struct renderer_desc *shown);

/* The fastest dot whose error is below that; -1: none is. */
int chart_cheapest(const struct chart *chart, double error);

#endif
