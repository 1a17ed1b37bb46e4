/* Places the picture in the window: fitted or enlarged, alone or beside the other one. */
#ifndef VIEWER_LOOK_H
#define VIEWER_LOOK_H

#include "viewer/state.h"

/* Sets the picture's rectangle, if there is a picture. */
void look_place(struct viewer *viewer);

/* Returns true if both pictures are shown whole: the right one lies shown.room.width further
 * right. */
bool look_is_beside(const struct viewer *viewer);

/* Writes the mouse's place in the left or right picture, 0 to 1, y down. Returns true if it is
 * on a picture. */
bool look_at_mouse(const struct viewer *viewer, float *x, float *y);

enum { LOOK_ZOOM_MOST = 64 };

/* Returns pixels of the window per pixel of the picture. look_enlarge keeps the middle and fits
 * the picture if it would get smaller than that. */
double look_zoom(const struct viewer *viewer);
void look_enlarge(struct viewer *viewer, double zoom);
void look_scroll(struct viewer *viewer, double steps);
void look_drag(struct viewer *viewer);

/* Switches between 1:1 and fitted. */
void look_toggle(struct viewer *viewer);
void look_step_layout(struct viewer *viewer);

#endif
