/* How the picture lies in the window: as large as fits or enlarged, alone or beside the
 * other one. */
#ifndef VIEWER_LOOK_H
#define VIEWER_LOOK_H

#include "viewer/state.h"

/* Where the picture lies, where there is one. */
void look_place(struct viewer *viewer);

/* Whether both pictures are there as a whole: the right one lies shown.room.width further right. */
bool look_is_beside(const struct viewer *viewer);

/* The mouse's place in the picture, or in the right one, 0 to 1, y down; whether it is on it. */
bool look_at_mouse(const struct viewer *viewer, float *x, float *y);

enum { LOOK_ZOOM_MOST = 64 };

/* Pixels of the window a pixel; look_enlarge keeps the middle where it is, and fits what would be
 * smaller. */
double look_zoom(const struct viewer *viewer);
void look_enlarge(struct viewer *viewer, double zoom);
void look_scroll(struct viewer *viewer, double steps);
void look_drag(struct viewer *viewer);

/* Between 1:1 and as large as fits. */
void look_toggle(struct viewer *viewer);
void look_step_layout(struct viewer *viewer);

#endif
