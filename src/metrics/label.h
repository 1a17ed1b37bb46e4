/* Draws small text into a picture with a font of 5 by 7 dots, for scales and titles. Needs no
 * library, because `make bundle` has none that renders text. */
#ifndef METRICS_LABEL_H
#define METRICS_LABEL_H

#include "base/image.h"

enum { LABEL_HEIGHT = 7 }; /* dots */

/* Returns the width in pixels. Digits, letters, all drawn in lower case, and ". - + / ( )" have
 * glyphs; others are blank. scale: pixels per dot. */
int label_width(const char *text, int scale);

/* Draws light grey text with its upper left corner at x, y, clipped to the picture. */
void label_draw(struct bitmap *picture, int x, int y, int scale, const char *text);

#endif
