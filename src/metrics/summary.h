/* Figures of many values. */
#ifndef METRICS_SUMMARY_H
#define METRICS_SUMMARY_H

struct summary {
    double value; /* the median, where nothing else is said */
    double p5, p95, minimum, maximum;
    int count;
};

/* Order statistics. Sorts the values; count is at least 1. */
struct summary summary_of(float *values, int count);

/* The x at which a curve that falls through the points, straight in logarithms between them, first has
 * a y; 0 where it begins below, infinity where it ends above. */
double log_interpolate(const double *x, const double *y, int count, double at);

#endif
