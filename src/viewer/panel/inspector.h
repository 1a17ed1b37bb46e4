/* The values of the pixel under the mouse: linear radiance, of the left picture, of the right one,
 * and the difference. */
#ifndef VIEWER_INSPECTOR_H
#define VIEWER_INSPECTOR_H

#include "viewer/state.h"

void inspector_draw(struct viewer *viewer);

#endif
