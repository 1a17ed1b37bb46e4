/* What every metric takes: a picture under test, the reference, and how they are looked at. */
#ifndef METRICS_COMPARISON_H
#define METRICS_COMPARISON_H

#include "base/image.h"

/* A 3840 pixel wide screen of 0.7 m seen from 0.7 m [Andersson et al. 2020]. */
#define DEFAULT_PIXELS_PER_DEGREE 67.0206

/* Exposures of HDR-FLIP, evenly from the first to the last. */
struct exposure_range {
    float first, last; /* EV */
    int count;         /* 0: as hdr_flip_exposures finds them */
};

/* Both pictures have three channels, linear R G B, finite, and the same size. */
struct comparison {
    const struct image *test, *reference;
    float pixels_per_degree; /* of FLIP */
    struct exposure_range exposures;
    int threads; /* 0 = all cores; the results do not depend on it */
};

#endif
