/* Draws text over the picture: times, counts, memory, messages. */
#ifndef VIEWER_OVERLAY_H
#define VIEWER_OVERLAY_H

#include "viewer/state.h"

/* Returns the width of the times at the window's left edge, with margins, pixels. */
float overlay_width(const struct viewer *viewer);
void overlay_draw(struct viewer *viewer);

#endif
