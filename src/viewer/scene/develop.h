/* Chooses the exposure of a picture, and converts a traced picture for the display. */
#ifndef VIEWER_DEVELOP_H
#define VIEWER_DEVELOP_H

#include "base/image.h"

/* Returns the exposure, EV in quarters of a stop, at which the filmic tone map shows most of a
 * picture. 0 for a black one. */
float develop_exposure(const struct image *image);

/* Returns the 95th percentile of the radiance of pixels that are not black. 0 for a black
 * picture. */
double develop_highlight(const struct image *image);

/* Applies exposure (EV) and the filmic tone map. The caller frees the bitmap. */
void develop_picture(const struct image *image, float exposure, struct bitmap *bitmap);

#endif
