/* Input of each metric: a picture under test, its reference, and the viewing conditions. */
#ifndef METRICS_COMPARISON_H
#define METRICS_COMPARISON_H

#include "base/image.h"

/* A screen 0.7 m wide with 3840 pixels, seen from 0.7 m [Andersson et al. 2020]. */
#define DEFAULT_PIXELS_PER_DEGREE 67.0206

/* Exposures of HDR-FLIP, evenly spaced from first to last. */
struct exposure_range {
    float first, last; /* EV */
    int count;         /* 0: chosen by hdr_flip_exposures */
};

/* Both pictures have three channels, linear R G B, finite, and the same size. */
struct comparison {
    const struct image *test, *reference;
    float pixels_per_degree; /* for FLIP */
    struct exposure_range exposures;
    int threads; /* 0: all cores; results do not depend on it */
};

#endif
