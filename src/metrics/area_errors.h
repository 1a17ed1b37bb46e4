/* Maps of errors by area: means over boxes, and the worst pixels. */
#ifndef METRICS_AREA_ERRORS_H
#define METRICS_AREA_ERRORS_H

#include "metrics/comparison.h"

/* Write to each pixel the squared error (metrics/errors.h) of the means over its box of 4 x 4 or 16
 * x 16 pixels: low-frequency error, without noise and edges shifted by a pixel. Boxes start at the
 * top left corner; the right and lower borders cut them. */
void box_error_4(const struct comparison *comparison, float *map);
void box_error_16(const struct comparison *comparison, float *map);

/* Writes to each of the worst 1 % of pixels (rounded up) its fraction of the total squared error,
 * times the number of pixels. All others get 0. The mean of the map is the fraction of the worst:
 * small for noise, near 1 if only some edges are wrong. Pixels that tie at the threshold share the
 * remaining ranks. */
void worst_share(const struct comparison *comparison, float *map);

#endif
