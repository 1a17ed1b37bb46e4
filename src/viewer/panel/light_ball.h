/* The light at a voxel as a ball: each place of its surface has the radiance that arrives from its direction. */
#ifndef VIEWER_LIGHT_BALL_H
#define VIEWER_LIGHT_BALL_H

#include "viewer/state.h"

/* Of the last click, into the area that is open; nothing where there is no such light. */
void light_ball_draw(const struct viewer *viewer);

#endif
