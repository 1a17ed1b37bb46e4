/* Parts of a primitive that do not touch each other: panels of one material that a tool joined.
 *
 * Triangles touch where a corner of one lies at a corner of the other, whether they share the vertex or
 * not.
 */
#ifndef SCENE_LIGHTS_ISLANDS_H
#define SCENE_LIGHTS_ISLANDS_H

#include "scene/scene.h"

/* Island i, from 0 on, has the primitive's indices from ends[i] to ends[i + 1]. free() frees ends. */
struct islands {
    int *ends;
    int count;
};

/* Moves the triangles of each island together, in the order of their first ones. */
void islands_init(struct islands *islands, struct primitive *primitive);

#endif
