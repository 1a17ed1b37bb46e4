/* HDR-FLIP: LDR-FLIP over every exposure at which something of the reference can be seen.
 *
 * [Andersson et al. 2021] "Visualizing and Communicating Errors in Rendered Images", Ray Tracing
 * Gems II, ch. 19. Exposures run from the one that brings the reference's brightest pixel to 0.85
 * of the ACES tone curve to the one that brings its median there, a stop or less apart; each pixel
 * keeps its largest error.
 *
 * Where the median luminance is 0 (half of the picture is black) the smallest positive one stands
 * for it, for otherwise the exposures would have no end.
 *
 * Cost: an LDR-FLIP per exposure.
 */
#ifndef METRICS_FLIP_HDR_FLIP_H
#define METRICS_FLIP_HDR_FLIP_H

#include "metrics/comparison.h"

/* The exposures at which the reference is looked at: at least two. */
struct exposure_range hdr_flip_exposures(const struct image *reference);

/* The error of each pixel; the mean is the error of the picture. map: height x width. */
void flip_hdr(const struct comparison *comparison, float *map);

#endif
