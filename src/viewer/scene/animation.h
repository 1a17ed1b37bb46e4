/* Time goes by: the scene is posed, and all that was not moved by hand goes where it is then. */
#ifndef VIEWER_ANIMATION_H
#define VIEWER_ANIMATION_H

#include "viewer/state.h"

/* Lets the animation play on, and poses the scene where the time has changed. */
void viewer_animate(struct viewer *viewer, double seconds);

/* To that time of the animation, seconds: around where it loops, else as far as it goes. */
void viewer_go_to(struct viewer *viewer, double time);

/* Where that is in a scene's animation. */
double viewer_time_in(const struct viewer *viewer, const struct scene *scene, double time);

/* Plays or pauses; begins anew where it had come to its end. */
void viewer_toggle_play(struct viewer *viewer);

#endif
