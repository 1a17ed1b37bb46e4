/* Sets the exposure: automatically when a scene is opened, then by the user. */
#ifndef VIEWER_EXPOSURE_H
#define VIEWER_EXPOSURE_H

#include "viewer/state.h"

/* viewer_begin_exposure asks for the automatic exposure of a newly opened scene, if wanted.
 * viewer_follow_exposure sets it after the first frame. */
void viewer_begin_exposure(struct viewer *viewer);
void viewer_follow_exposure(struct viewer *viewer);

/* viewer_expose changes the exposure by stops. viewer_reset_exposure returns to the scene's
 * first one. */
void viewer_expose(struct viewer *viewer, float by);
void viewer_reset_exposure(struct viewer *viewer);

#endif
