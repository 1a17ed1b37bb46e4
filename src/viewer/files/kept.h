/* Keeps state between runs: settings that the user saves, and how each scene was left. */
#ifndef VIEWER_KEPT_H
#define VIEWER_KEPT_H

#include "viewer/state.h"

/* Saves settings, camera and lights, and shows the path or the error. viewer_tell_saved shows
 * the result of such a write. */
void viewer_save_session(struct viewer *viewer);
void viewer_tell_saved(struct viewer *viewer, bool ok, const char *path);

/* Keep how each scene was left, if something was changed. kept_begin restores it when the scene
 * is opened without options that set its look; kept_begin_afresh shows it by the command line's
 * options instead. */
void kept_save(struct viewer *viewer);
void kept_begin(struct viewer *viewer);
void kept_begin_afresh(struct viewer *viewer);
void kept_free(struct viewer *viewer);

#endif
