/* Order statistics. */
#ifndef METRICS_QUANTILE_H
#define METRICS_QUANTILE_H

#include <stddef.h>

/* Returns the value that the fraction q in [0, 1] of the values does not exceed. The median of an
 * even count is the upper of the two middle values. Sorts the values. count: at least 1. */
float quantile(float *values, size_t count, double q);

#endif
