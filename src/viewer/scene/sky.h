/* Opens, turns, scales and removes the sky of the open scene. */
#ifndef VIEWER_SKY_H
#define VIEWER_SKY_H

#include "viewer/state.h"

/* Reads a sky. It replaces the one before once its shaders are compiled. Error: also shown; the
 * sky before stays. */
bool viewer_open_sky(struct viewer *viewer, const char *path);

/* Shows the sky whose shaders are compiled. */
void viewer_follow_sky(struct viewer *viewer);

/* Drops a sky that waits for its shaders. It is freed once nothing is being compiled. */
void viewer_forget_sky(struct viewer *viewer);

/* Updates the panel's rows of the sky. */
void viewer_tell_sky(struct viewer *viewer);

/* Updates the picture after a change of the sky's turn or strength. */
void viewer_touch_sky(struct viewer *viewer);

/* viewer_sky_shines: the sky shines. viewer_can_do_without_sky: something else shines, too. */
bool viewer_sky_shines(const struct viewer *viewer);
bool viewer_can_do_without_sky(const struct viewer *viewer);
void viewer_let_sky_shine(struct viewer *viewer, bool shines);

/* Returns true if the sky can be removed: a light is left, and the scene's lights shine if no
 * other does. */
bool viewer_can_remove_sky(const struct viewer *viewer);
void viewer_remove_sky(struct viewer *viewer);

/* Shows the sky of a session at once, with its lights. Error: of the file, or of the lights. */
bool viewer_show_sky(struct viewer *viewer, const struct session *session);

#endif
