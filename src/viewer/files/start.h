/* The first minute: the empty window's pictures of scenes to click, and the list of files. */
#ifndef VIEWER_START_H
#define VIEWER_START_H

#include "viewer/state.h"

void start_draw(struct viewer *viewer);
void start_free(struct start *start);

/* Whether a picture has been made, or the desktop's dialog may answer. */
bool start_has_news(struct start *start);

/* Lets the user choose a file. */
void viewer_ask_file(struct viewer *viewer);

#endif
