/* The empty window's pictures of scenes to click, and the desktop's dialog of files. */
#ifndef VIEWER_START_H
#define VIEWER_START_H

#include "viewer/state.h"

void start_draw(struct viewer *viewer);

/* Lets the user choose a file. */
void viewer_ask_file(struct viewer *viewer);

#endif
