/* How bright the picture is shown: by itself when a scene is opened, then as the user likes. */
#ifndef VIEWER_EXPOSURE_H
#define VIEWER_EXPOSURE_H

#include "viewer/state.h"

/* For a scene that has been opened: it is exposed by itself where that is wanted, with its first
 * frame. */
void viewer_begin_exposure(struct viewer *viewer);
void viewer_follow_exposure(struct viewer *viewer);

/* It stays as it is, and is the one that the scene began with. */
void viewer_keep_exposure(struct viewer *viewer);

/* Stops up or down; and back to where the scene began. */
void viewer_expose(struct viewer *viewer, float by);
void viewer_reset_exposure(struct viewer *viewer);

#endif
