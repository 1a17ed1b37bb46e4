/* The bar of an animation below the picture: where it is, in seconds and frames, and what to do with
 * it. */
#ifndef VIEWER_TIMELINE_H
#define VIEWER_TIMELINE_H

#include "viewer/state.h"

/* Below the pictures' area; 0 = it is not there. */
float timeline_height(const struct viewer *viewer);
void timeline_draw(struct viewer *viewer);

/* Asks for range and folder of a clip to record: all of it, and the working folder, at first. */
void timeline_ask(struct viewer *viewer, enum record_kind kind);
void timeline_draw_request(struct viewer *viewer);

/* Pauses, and goes so many frames on. */
void timeline_step(struct viewer *viewer, int frames);

#endif
