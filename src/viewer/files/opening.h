/* Opens scenes: a thread reads one, a coarse picture shows it while its shaders are compiled,
 * and then it replaces the scene before. */
#ifndef VIEWER_OPENING_H
#define VIEWER_OPENING_H

#include "viewer/state.h"

void viewer_open(struct viewer *viewer, const char *path);

/* Opens the scene's file again, with the chosen scenes and variants and the same view. */
void viewer_reload(struct viewer *viewer);

/* Calls viewer_reload if the file has changed and then rested. Looks twice a second. */
void viewer_watch_file(struct viewer *viewer);

/* Shows a loaded scene once its shaders are compiled. Returns false if it cannot be shown; the
 * scene before then stays. */
bool viewer_poll_loader(struct viewer *viewer);

/* Returns true if a scene or a sky is being read, or has been read and is not shown yet. */
bool viewer_is_opening(struct viewer *viewer);

/* Stops opening; the scene before stays. */
void viewer_stop_opening(struct viewer *viewer);

/* Writes the current step of opening and its seconds. */
void viewer_tell_opening(struct viewer *viewer, char *text, size_t size);

/* Shows the error and closes the scene, which cannot be drawn any more. */
void viewer_close_scene(struct viewer *viewer);

/* Opens a file that was dropped, typed or chosen: a scene, a sky of the open scene, a reference,
 * or settings. Channels and shape of a picture decide between sky and reference. */
void viewer_take_file(struct viewer *viewer, const char *path);

#endif
