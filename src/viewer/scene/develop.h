/* How bright a picture is to be shown, and a traced picture as the display shows it. */
#ifndef VIEWER_DEVELOP_H
#define VIEWER_DEVELOP_H

#include "base/image.h"

/* The exposure, EV, in quarters of a stop, at which a picture shows most of itself by the filmic
 * tone map; 0 of a black one. */
float develop_exposure(const struct image *image);

/* What all but the brightest twentieth of what is not black stays below; 0 of a black picture. */
double develop_highlight(const struct image *image);

/* Whether nothing is seen that shines or is lit. */
bool develop_is_black(const struct image *image);

/* By the filmic tone map; the caller frees the bitmap. */
void develop_picture(const struct image *image, float exposure, struct bitmap *bitmap);

#endif
