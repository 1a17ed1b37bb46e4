/* Fraction of the squared error in the worst 1 % of the pixels: small for noise, near 1 if only
 * some edges are wrong. */
#ifndef METRICS_WORST_SHARE_H
#define METRICS_WORST_SHARE_H

#include "metrics/comparison.h"

/* Writes to each of the worst 1 % of pixels (rounded up) its fraction of the total squared error,
 * times the number of pixels. All others get 0. The mean of the map is the fraction of the worst.
 * Pixels that tie at the threshold share the remaining ranks. */
void worst_share(const struct comparison *comparison, float *map);

#endif
