/* What is written over the picture: times, counts, memory, messages. */
#ifndef VIEWER_OVERLAY_H
#define VIEWER_OVERLAY_H

#include "viewer/state.h"

/* Of the window's left edge what the times take, with the edges. */
float overlay_width(const struct viewer *viewer);
void overlay_draw(struct viewer *viewer);

#endif
