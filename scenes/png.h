/* Small pictures as PNG, uncompressed, so that their bytes depend on nothing but their texels. */
#ifndef SCENES_PNG_H
#define SCENES_PNG_H

#include "base/text.h"

enum { PNG_SIDE_MOST = 64 };

/* RGBA, 8 bits each, from the top row on; no side longer than PNG_SIDE_MOST. */
void png_append(struct text *to, int width, int height, const unsigned char *rgba);

#endif
