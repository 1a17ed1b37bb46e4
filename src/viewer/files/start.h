/* Draws the empty window: scenes to click, and the dialog of files. */
#ifndef VIEWER_START_H
#define VIEWER_START_H

#include "viewer/state.h"

void start_draw(struct viewer *viewer);

/* Accepts a window that was never empty. */
void start_free(struct viewer *viewer);

/* Opens the dialog of files. */
void viewer_ask_file(struct viewer *viewer);

#endif
