/* LDR-FLIP: visible difference for a viewer who flips between two pictures, 0 to 1.
 *
 * [Andersson et al. 2020] "FLIP: A Difference Evaluator for Alternating Images", HPG 2020. A colour
 * pipeline (contrast sensitivity, perceptual distance) and a feature pipeline (edges and points)
 * meet in the last step. Values are clamped to [0, 1], the range of a display. The pictures are
 * linear, so FLIP's first step, decoding sRGB, is omitted.
 *
 * Cost: 4 separable filters at once, twice per picture (metrics/flip/flip_filter.h). */
#ifndef METRICS_FLIP_FLIP_H
#define METRICS_FLIP_FLIP_H

#include "metrics/comparison.h"

/* Writes the error of each pixel to map, height x width. The mean is the picture's error. */
void flip_ldr(const struct comparison *comparison, float *map);

#endif
