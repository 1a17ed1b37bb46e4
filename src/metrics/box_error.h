/* Errors of pictures averaged over square boxes: low-frequency error, without noise and edges
 * shifted by a pixel. */
#ifndef METRICS_BOX_ERROR_H
#define METRICS_BOX_ERROR_H

#include "metrics/comparison.h"

/* Write to each pixel the squared error (metrics/errors.h) of the means over its box of 4 x 4 or 16
 * x 16 pixels. Boxes start at the top left corner; the right and lower borders cut them. */
void box_error_4(const struct comparison *comparison, float *map);
void box_error_16(const struct comparison *comparison, float *map);

#endif
