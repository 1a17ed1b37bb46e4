/* Animation: clips, and the values of their channels between keys [glTF 2.0, 3.11]. */
#ifndef SCENE_ANIMATION_H
#define SCENE_ANIMATION_H

#include "scene/scene.h"

/* Writes the channel's numbers, channel->width of them, at a time in seconds. The first and last
 * keys hold outside the keys. Rotations are unit quaternions and take the shorter way. */
void channel_sample(const struct channel *channel, double time, float *out);

/* Returns the next channel of the playing clips, in the order in which they act. Start with a
 * zeroed place. NULL: the end. */
struct channel_place {
    int playing, channel;
};
const struct channel *scene_next_channel(const struct scene *scene, struct channel_place *place);

/* Returns the duration of the longest playing clip and of all metaballs, seconds. 0: nothing
 * moves. */
double scene_duration(const struct scene *scene);

void clip_free(struct clip *clip);

#endif
