/* The desktop viewer: a window on a scene, rendered live.
 *
 * Each turn of the loop takes the user's input, lets the parts change what is wanted (struct
 * viewer), renders where something changed, and shows the picture. A failure leaves a message and
 * the last good state. */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include "viewer/state.h"

/* Runs until the window is closed, or for desc->frames. Error: no window; if frames are counted,
 * also a file that fails. */
bool viewer_run(const struct viewer_desc *desc);

/* Opens the viewer, to run it step by step. Error: no window; nothing is left open. */
bool viewer_begin(struct viewer *viewer, const struct viewer_desc *desc);

/* Runs one turn of the loop. Error: as viewer_run. */
bool viewer_turn(struct viewer *viewer);
void viewer_end(struct viewer *viewer);

#endif
