/* What outlives the window: settings that the user saves, and how each scene was left. */
#ifndef VIEWER_KEPT_H
#define VIEWER_KEPT_H

#include "viewer/state.h"

/* Saves settings, camera and lights, and says where; or the error. */
void viewer_save_session(struct viewer *viewer);
void viewer_tell_saved(struct viewer *viewer, bool ok, const char *path);

/* How each scene was left: kept where something was changed, and taken up when
 * the scene is opened again and no option says how it is to look. */
void kept_save(struct viewer *viewer);
void kept_begin(struct viewer *viewer);
void kept_begin_afresh(struct viewer *viewer);
void kept_free(struct viewer *viewer);

#endif
