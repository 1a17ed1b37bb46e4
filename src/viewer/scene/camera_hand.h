/* Moves the camera by mouse and keys. It circles, zooms to and frames the point under the mouse. */
#ifndef VIEWER_CAMERA_HAND_H
#define VIEWER_CAMERA_HAND_H

#include "viewer/state.h"

enum { CAMERA_FIELD_LEAST = 2, CAMERA_FIELD_MOST = 150 }; /* degrees, vertical */

/* Notes that the user has moved the camera. */
void camera_hand_touch(struct viewer *viewer);

/* Returns the speed of flying, m/s. */
float camera_hand_speed(const struct viewer *viewer);
void camera_hand_fly(struct viewer *viewer, double seconds);
void camera_hand_drag(struct viewer *viewer);
void camera_hand_scroll(struct viewer *viewer);
void camera_hand_frame(struct viewer *viewer);

#endif
