/* The error of a frame that has no truth: told from some of its pixels, which are path-traced. */
#ifndef MEASURE_ESTIMATE_H
#define MEASURE_ESTIMATE_H

#include "base/image.h"
#include "measure/measure.h"

struct estimate {
    struct image truth; /* of the pixels alone, one of each every x every */
    int every;
    double noise; /* of its indirect layer: standard error, RMS over the mean */
};

/* Traces about ESTIMATE_SIDE^2 pixels of the desc's stage in its size, with its bounces and materials, until the
 * noise is below the one given. Error: the tracer's. */
enum { ESTIMATE_SIDE = 96 };
bool estimate_init(struct estimate *estimate, const struct measure_desc *desc, double noise);

/* Accepts a zeroed one. */
void estimate_free(struct estimate *estimate);

/* Relative RMSE of the indirect layer of what the renderer shows, as metrics have it, the truth's noise
 * taken off as squares. Error: out of memory, the context is lost, or a value is not finite. */
bool estimate_error(const struct estimate *estimate, struct renderer *renderer, double *error);

/* The same of a picture with all layers. */
bool estimate_picture_error(const struct estimate *estimate, const struct image *picture,
                            double *error);

#endif
