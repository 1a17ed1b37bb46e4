/* A surface element of radiosity: its bins as an unfolded cube, its links as lines over the picture. */
#ifndef VIEWER_ELEMENT_CUBE_H
#define VIEWER_ELEMENT_CUBE_H

#include "viewer/state.h"

/* Of the last click, into the area that is open; nothing where the technique has no elements. */
void element_cube_draw(const struct viewer *viewer);

/* Over the picture, from the element to its partners, in the colours of their levels. */
void element_cube_draw_links(const struct viewer *viewer);

#endif
