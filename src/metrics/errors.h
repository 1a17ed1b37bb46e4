/* Errors of single pixels, each a mean over R, G and B. Metrics are means of them over the picture
 * (metrics/metric.h). v is the value under test, r the reference. */
#ifndef METRICS_ERRORS_H
#define METRICS_ERRORS_H

#include "metrics/comparison.h"

float signed_error(const struct comparison *comparison, int x, int y);   /* v - r */
float absolute_error(const struct comparison *comparison, int x, int y); /* |v - r| */
float squared_error(const struct comparison *comparison, int x, int y);  /* (v - r)^2 */

/* (v - r)^2 / (r + 0.01)^2, as in pbrt: relative, as the eye adapts to dark and bright parts. */
float squared_relative_error(const struct comparison *comparison, int x, int y);

/* |v - r| / (|v| + |r| + 0.01), in [0, 1): the symmetric error used for denoisers [Vogels et al.
 * 2018, Denoising with Kernel Prediction and Asymmetric Loss Functions]. */
float symmetric_relative_error(const struct comparison *comparison, int x, int y);

/* (v - r)^2 of display values: clamped to [0, 1] and sRGB-encoded. */
float squared_display_error(const struct comparison *comparison, int x, int y);

/* |grad (v - r)|^2 by differences to the right and lower neighbours; 0 beyond the border. Small for
 * a constant offset, large for false edges: banding, hard-shadow steps, noise. */
float squared_gradient_error(const struct comparison *comparison, int x, int y);

#endif
