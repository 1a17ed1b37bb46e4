/* A chart of error against time, as SVG within a page: both axes logarithmic, a point with a name for each subject. */
#ifndef APPS_REPORT_CHART_H
#define APPS_REPORT_CHART_H

#include <stdio.h>

struct chart_point {
    const char *name;
    double x, y; /* positive */
};

struct chart {
    const char *x_title, *y_title;
    const struct chart_point *points;
    int count;
    double floor; /* a line across, of the reference's noise; 0 = none */
};

void chart_print(FILE *out, const struct chart *chart);

#endif
