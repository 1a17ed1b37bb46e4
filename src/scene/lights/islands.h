/* Parts of a primitive that do not touch: for example panels of one material that a tool joined.
 * Solids of a few flat faces, for example boxes, are split into these (scene/lights/faces.h).
 *
 * Triangles touch if corners have equal positions, with or without a shared vertex. */
#ifndef SCENE_LIGHTS_ISLANDS_H
#define SCENE_LIGHTS_ISLANDS_H

#include "scene/scene.h"

/* Island i has the primitive's indices ends[i] to ends[i + 1] - 1. The caller frees `ends`. */
struct islands {
    int *ends;
    int count;
};

/* Sorts the triangles by island, in the order of their first triangles. */
void islands_init(struct islands *islands, struct primitive *primitive);

#endif
