/* Handles keys and mouse. The table of keys is also the help page. */
#ifndef VIEWER_CONTROLS_H
#define VIEWER_CONTROLS_H

#include "viewer/state.h"

void controls_update(struct viewer *viewer, double seconds);
void controls_draw_help(void);

#endif
