/* Plays the animation: poses the scene, and moves all that was not moved by hand. */
#ifndef VIEWER_ANIMATION_H
#define VIEWER_ANIMATION_H

#include "viewer/state.h"

/* Advances the animation by `seconds` and poses the scene if the time has changed. */
void viewer_animate(struct viewer *viewer, double seconds);

/* Goes to a time of the animation, seconds. Wraps it if the animation loops, else clamps it. */
void viewer_go_to(struct viewer *viewer, double time);

/* Returns that time in a scene's animation, seconds. */
double viewer_time_in(const struct viewer *viewer, const struct scene *scene, double time);

/* Plays or pauses. Begins again if the animation is at its end. */
void viewer_toggle_play(struct viewer *viewer);

#endif
