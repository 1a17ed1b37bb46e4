/* A chart of points in series, drawn by gnuplot as SVG and PNG.
 *
 * Series differ by mark, dash and grey as well as by colour, so that a black and white print reads.
 */
#ifndef APPS_BENCH_PLOT_H
#define APPS_BENCH_PLOT_H

#include "apps/bench_case.h"

enum plot_side { PLOT_RIGHT_ABOVE, PLOT_LEFT_BELOW, PLOT_RIGHT_BELOW, PLOT_LEFT_ABOVE, PLOT_SIDES };

struct plot_point {
    double x, y;
    char label[BENCH_NAME_SIZE]; /* "" = none */
    enum plot_side side;         /* of the point that the label stands on */
};

struct plot_series {
    char name[BENCH_NAME_SIZE];
    struct plot_point *points;
    int count;
};

struct plot {
    const char *title, *x_label, *y_label;
    bool log_y, linear_x; /* x is logarithmic unless linear */
    struct plot_series *series;
    int count;
    /* Points of all series that a line of their own connects in steps, with rings around them. */
    struct plot_series emphasis;
};

void plot_series_add(struct plot_series *series, const struct plot_point *point);

/* Adds a point to the series of that name, which is made when it is new. */
void plot_add(struct plot *plot, const char *series, const struct plot_point *point);
void plot_free(struct plot *plot);

/* The range of an axis: that of the values with some room around them. */
void plot_span(const struct plot *plot, bool of_y, double *low, double *high);

/* Writes path.svg and path.png; folders on the way are made. Error: gnuplot is missing or fails. */
bool plot_draw(const struct plot *plot, const char *path);

/* The ticks of a logarithmic axis over [low, high]; returns their number, at most count. */
int plot_log_ticks(double low, double high, double *ticks, int count);

#endif
