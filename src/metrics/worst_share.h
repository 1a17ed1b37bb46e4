/* How much of an error few pixels have: near the share of the pixels for noise, near 1 where the
 * picture is right but for some edges. */
#ifndef METRICS_WORST_SHARE_H
#define METRICS_WORST_SHARE_H

#include "metrics/comparison.h"

/* Each pixel of the worst 1 % (rounded up) by squared error gets its share of the whole picture's,
 * times the number of pixels; all others get 0. The mean is the share that the worst have. Pixels
 * as bad as the best of the worst divide that one's place among them. */
void worst_share(const struct comparison *comparison, float *map);

#endif
