/* The desktop viewer: a window on a scene, rendered live.
 *
 * Each turn of the loop takes the user's input, lets the parts change what is wanted (struct
 * viewer), renders where something changed, and shows the picture. A failure leaves a message and
 * the last good state. */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include "viewer/state.h"

/* Runs until the window is closed, or for desc->frames. Error: no window, or where frames are
 * counted a file that fails. */
bool viewer_run(const struct viewer_desc *desc);

/* The same step by step. viewer_begin: error: no window; nothing is left open. */
bool viewer_begin(struct viewer *viewer, const struct viewer_desc *desc);

/* Error: as viewer_run. */
bool viewer_turn(struct viewer *viewer);
void viewer_end(struct viewer *viewer);

#endif
