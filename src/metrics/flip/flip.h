/* LDR-FLIP: how much a viewer who flips between two pictures sees them differ, 0 to 1.
 *
 * [Andersson et al. 2020] "FLIP: A Difference Evaluator for Alternating Images", HPG 2020. A colour
 * pipeline (contrast sensitivity, perceptual distance) and a feature pipeline (edges and points)
 * meet in the last step. Values are clamped to [0, 1], what a screen can show; the pictures are
 * linear, and so FLIP's first step, decoding sRGB, is already done.
 *
 * Cost: 4 separable filters at once, twice per picture (metrics/flip/flip_filter.h).
 */
#ifndef METRICS_FLIP_FLIP_H
#define METRICS_FLIP_FLIP_H

#include "metrics/comparison.h"

/* The error of each pixel; the mean is the error of the picture. map: height x width. */
void flip_ldr(const struct comparison *comparison, float *map);

#endif
