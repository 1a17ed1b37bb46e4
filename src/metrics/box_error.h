/* The error that is left after both pictures are averaged over square boxes: what is wrong over
 * areas, without noise and edges that are a pixel off. */
#ifndef METRICS_BOX_ERROR_H
#define METRICS_BOX_ERROR_H

#include "metrics/comparison.h"

/* Each pixel gets the squared error (metrics/errors.h) of the means over its box of 4 x 4 or 16 x
 * 16 pixels. Boxes start at the top left corner; the right and lower border cut them. */
void box_error_4(const struct comparison *comparison, float *map);
void box_error_16(const struct comparison *comparison, float *map);

#endif
