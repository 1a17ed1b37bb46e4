#include "metrics/summary.h"

#include "metrics/quantile.h"

#include <math.h>

struct summary summary_of(float *values, int count) {
    size_t n = (size_t)count;
    return (struct summary){
        .value = (double)quantile(values, n, .5),
        .p5 = (double)quantile(values, n, .05),
        .p95 = (double)quantile(values, n, .95),
        .minimum = (double)quantile(values, n, 0),
        .maximum = (double)quantile(values, n, 1),
        .count = count,
    };
}

double log_interpolate(const double *x, const double *y, int count, double at) {
    if (count > 0 && at >= y[0])
        return at > y[0] ? 0 : x[0];
    for (int i = 1; i < count; i++)
        if (at >= y[i])
            return x[i - 1] * pow(x[i] / x[i - 1], log(at / y[i - 1]) / log(y[i] / y[i - 1]));
    return INFINITY;
}
