/* Draws the values of the pixel under the mouse: linear radiance of both pictures, and their
 * difference. */
#ifndef VIEWER_INSPECTOR_H
#define VIEWER_INSPECTOR_H

#include "viewer/state.h"

void inspector_draw(struct viewer *viewer);

#endif
