/* The error of a frame that has no reference: estimated from some of its pixels, which are path-traced.
 *
 * Each of them twice, by paths that have nothing in common. The product of what a picture differs from the one and
 * from the other has the square of its error for its mean, whatever the noise of both: it averages out over the
 * pixels, so that few paths do, and more of them are traced only while they decide.
 */
#ifndef QUALITY_ESTIMATE_H
#define QUALITY_ESTIMATE_H

#include "base/image.h"
#include "quality/measure.h"

struct estimate {
    struct measure_desc desc;
    struct image
        halves[2];      /* their indirect layers: of the pixels alone, one of each every x every */
    int every, samples; /* of a pixel, in each half */
};

/* Traces about ESTIMATE_SIDE^2 pixels of the desc's stage in its size, with its bounces and materials. The stage must stay as
 * it is. Error: the tracer's. */
enum { ESTIMATE_SIDE = 96 };
bool estimate_init(struct estimate *estimate, const struct measure_desc *desc);

/* Accepts a zeroed one. */
void estimate_free(struct estimate *estimate);

/* Relative RMSE of the indirect layer of a picture with all layers, as metrics have it of layer_extract_covered, and whether that is more than
 * asked for: to a twentieth if it is not, else to a seventh, or as exactly as the most paths tell it. Error: the
 * tracer's. */
bool estimate_picture_error(struct estimate *estimate, const struct image *picture, double asked,
                            double *error);

/* The same of what the renderer shows. Error: also out of memory, the context is lost, or a value is not finite. */
bool estimate_error(struct estimate *estimate, struct renderer *renderer, double asked,
                    double *error);

#endif
