/* The bar of an animation below the picture: where it is, in seconds and frames, and what to do
 * with it. */
#ifndef VIEWER_TIMELINE_H
#define VIEWER_TIMELINE_H

#include "viewer/state.h"

/* Below the pictures' area; 0 = it is not there. */
float timeline_height(const struct viewer *viewer);
void timeline_draw(struct viewer *viewer);

/* Pauses, and goes so many frames on. */
void timeline_step(struct viewer *viewer, int frames);

#endif
