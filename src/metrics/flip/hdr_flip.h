/* HDR-FLIP: LDR-FLIP over all exposures that show a part of the reference.
 *
 * [Andersson et al. 2021] "Visualizing and Communicating Errors in Rendered Images", Ray Tracing
 * Gems II, ch. 19. The first exposure maps the reference's brightest pixel to 0.85 of the ACES tone
 * curve, the last its median. Steps are at most one stop. Each pixel keeps its largest error. If
 * half of the picture is black, the smallest positive luminance replaces the median, which is 0;
 * otherwise the range would be infinite.
 *
 * Cost: an LDR-FLIP per exposure. */
#ifndef METRICS_FLIP_HDR_FLIP_H
#define METRICS_FLIP_HDR_FLIP_H

#include "metrics/comparison.h"

/* Returns the exposures for a reference: at least two. */
struct exposure_range hdr_flip_exposures(const struct image *reference);

/* Writes the error of each pixel to map, height x width. The mean is the picture's error. */
void flip_hdr(const struct comparison *comparison, float *map);

#endif
