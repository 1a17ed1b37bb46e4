/* Order statistics. */
#ifndef METRICS_QUANTILE_H
#define METRICS_QUANTILE_H

#include <stddef.h>

/* The value that the fraction q in [0, 1] of the values does not exceed; of an even count's middle
 * two, the upper is the median. Sorts the values; count is at least 1. */
float quantile(float *values, size_t count, double q);

#endif
