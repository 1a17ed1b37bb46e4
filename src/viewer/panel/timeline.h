/* Draws the bar of an animation below the picture: time in seconds and frames, and buttons. */
#ifndef VIEWER_TIMELINE_H
#define VIEWER_TIMELINE_H

#include "viewer/state.h"

/* Returns the bar's height below the pictures, pixels. 0: there is no bar. */
float timeline_height(const struct viewer *viewer);
void timeline_draw(struct viewer *viewer);

/* Pauses and steps by a number of frames. */
void timeline_step(struct viewer *viewer, int frames);

#endif
