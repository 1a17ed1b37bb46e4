/* Small text in a picture: a font of 5 by 7 dots, for scales and titles. It is drawn here, because the bundle
 * writes heat maps and has no library that renders text. */
#ifndef METRICS_LABEL_H
#define METRICS_LABEL_H

#include "base/image.h"

enum { LABEL_HEIGHT = 7 }; /* dots */

/* Digits, lower-case letters and ". - +"; others are blank. scale: pixels per dot. */
int label_width(const char *text, int scale);

/* Draws in light grey with the upper left corner at x, y; cut off at the picture's border. */
void label_draw(struct bitmap *picture, int x, int y, int scale, const char *text);

#endif
