/* Summary statistics. */
#ifndef METRICS_SUMMARY_H
#define METRICS_SUMMARY_H

struct summary {
    double value; /* median, unless the user of the struct says otherwise */
    double p5, p95, minimum, maximum;
    int count;
};

/* Returns median, quantiles and extremes. Sorts the values. count: at least 1. */
struct summary summary_of(float *values, int count);

/* Returns the x where a falling curve through the points first reaches y = `at`, interpolated in
 * logarithms. 0: the curve starts below; infinity: it ends above. */
double log_interpolate(const double *x, const double *y, int count, double at);

#endif
