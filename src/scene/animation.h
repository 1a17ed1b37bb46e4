/* Animation: clips, and the values of their channels between keys [glTF 2.0, 3.11]. */
#ifndef SCENE_ANIMATION_H
#define SCENE_ANIMATION_H

#include "scene/scene.h"

/* The channel's width of numbers at a time in seconds. Before the first key and after the last one
 * their values hold. Rotations are unit quaternions, and go the short way around. */
void channel_sample(const struct channel *channel, double time, float *out);

/* Steps through the channels of the clips that play, in the order in which they act: begins with a zeroed place;
 * NULL at the end. */
struct channel_place {
    int playing, channel;
};
const struct channel *scene_next_channel(const struct scene *scene, struct channel_place *place);

/* Of the longest clip that plays and of all metaballs, seconds; 0 = nothing moves. */
double scene_duration(const struct scene *scene);

void clip_free(struct clip *clip);

#endif
