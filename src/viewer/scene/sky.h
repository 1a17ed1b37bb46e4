/* The sky of the scene that is open: it comes, turns, shines and goes. */
#ifndef VIEWER_SKY_H
#define VIEWER_SKY_H

#include "viewer/state.h"

/* Reads a sky, which takes the place of the one before when its shaders have been compiled. Error:
 * shown, too; the one before stays. */
bool viewer_open_sky(struct viewer *viewer, const char *path);

/* Takes the sky whose shaders have come. */
void viewer_follow_sky(struct viewer *viewer);

/* Lets a sky go that waits for its shaders; it is freed when none are being compiled. */
void viewer_forget_sky(struct viewer *viewer);

/* What of a sky the panel's rows tell. */
void viewer_tell_sky(struct viewer *viewer);

/* It was turned, or its strength was changed, in place. */
void viewer_touch_sky(struct viewer *viewer);

/* Whether it shines; and whether anything else does, so that it need not. */
bool viewer_sky_shines(const struct viewer *viewer);
bool viewer_can_do_without_sky(const struct viewer *viewer);
void viewer_let_sky_shine(struct viewer *viewer, bool shines);

/* Whether something is there that shines without it: then it can be removed, and the scene's lights
 * shine where no other does. */
bool viewer_can_remove_sky(const struct viewer *viewer);
void viewer_remove_sky(struct viewer *viewer);

/* The sky of a session, at once, with its lights. Error: of the file, or of the lights. */
bool viewer_show_sky(struct viewer *viewer, const struct session *session);

#endif
