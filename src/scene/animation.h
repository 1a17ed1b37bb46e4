/* Animation: clips, and the values of their channels between keys [glTF 2.0, 3.11]. */
#ifndef SCENE_ANIMATION_H
#define SCENE_ANIMATION_H

#include "scene/scene.h"

/* The channel's width of numbers at a time in seconds. Before the first key and after the last one
 * their values hold. Rotations are unit quaternions, and go the short way around. */
void channel_sample(const struct channel *channel, double time, float *out);

/* Lets the clip of that name or number play. Error: lists the clips when there is none such. */
bool scene_select_clip(struct scene *scene, const char *text);

/* The clip that plays; NULL = none. */
const struct clip *scene_clip(const struct scene *scene);

/* Of the clip that plays and of all metaballs, seconds; 0 = nothing moves. */
double scene_duration(const struct scene *scene);

void clip_free(struct clip *clip);

#endif
