/* Estimates the error of a frame without a reference, from path-traced pixels.
 *
 * Each pixel is traced twice with independent paths. The product of both differences from the
 * picture, averaged over pixels, is an unbiased estimate of the squared error, for any noise. Few
 * paths per pixel are therefore enough. More are traced only while they decide. */
#ifndef QUALITY_ESTIMATE_H
#define QUALITY_ESTIMATE_H

#include "base/image.h"
#include "quality/measure.h"

struct estimate {
    struct measure_desc desc;
    const char *layer; /* layer that errors are of: "indirect", or "" for the whole picture */
    /* Layers of the traced pixels, one in each block of every x every pixels. */
    struct image halves[2];
    int every, samples; /* samples: per pixel, in each half */
};

/* Traces about ESTIMATE_SIDE^2 pixels of desc's stage at its size, bounces and materials. The stage
 * must not change afterwards. Error: as of the path tracer. */
enum { ESTIMATE_SIDE = 96 };
bool estimate_init(struct estimate *estimate, const struct measure_desc *desc, const char *layer);

/* Accepts a zeroed estimate. */
void estimate_free(struct estimate *estimate);

/* Computes the relative RMSE of the layer of a picture, weighted by coverage as in
 * layer_extract_covered. The precision is a twentieth if the error is at most `asked`, else a
 * seventh, or that of the largest number of paths. Error: as of the path tracer. */
bool estimate_picture_error(struct estimate *estimate, const struct image *picture, double asked,
                            double *error);

/* Computes this error of the renderer's picture. Error: also out of memory, a lost context, a value
 * that is not finite. */
bool estimate_error(struct estimate *estimate, struct renderer *renderer, double asked,
                    double *error);

#endif
