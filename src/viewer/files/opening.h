/* Scenes come and go: one is read on a thread, seen as a coarse picture while its shaders are
 * compiled, and then takes the place of the one before. */
#ifndef VIEWER_OPENING_H
#define VIEWER_OPENING_H

#include "viewer/state.h"

void viewer_open(struct viewer *viewer, const char *path);

/* Opens the scene's file anew, with the scenes and variants that were chosen, and looks at it as
 * before. */
void viewer_reload(struct viewer *viewer);

/* Does so where the file was changed and has rested since the last look; looks twice a second. */
void viewer_watch_file(struct viewer *viewer);

/* Takes a scene that has been loaded, when its shaders are compiled. False: it cannot be shown; the
 * one before stays. */
bool viewer_poll_loader(struct viewer *viewer);

/* Whether one is being read, or has been and is not shown yet, or a sky. */
bool viewer_is_opening(struct viewer *viewer);

/* Lets go what is being opened; what was there before stays. */
void viewer_stop_opening(struct viewer *viewer);

/* What is done of that now, for how long, in words. */
void viewer_tell_opening(struct viewer *viewer, char *text, size_t size);

/* Shows the error, and lets the scene go, which cannot be drawn any more. */
void viewer_close_scene(struct viewer *viewer);

/* Opens a file that was dropped, typed or chosen: a scene, the sky of the one that is open, a
 * reference, or settings; the channels and the shape of a picture decide which it is. */
void viewer_take_file(struct viewer *viewer, const char *path);

#endif
