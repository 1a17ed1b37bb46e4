/* A camera and a light for files that bring none. */
#ifndef SCENE_FRAMING_H
#define SCENE_FRAMING_H

#include "scene/mesh/geometry.h"

/* The nodes that carry them; -1 = the scene has its own. */
struct framing {
    int camera, light;
};

/* Adds nodes for a camera and a spot, each only where the scene has none, and notes it on stderr. */
void framing_add(struct framing *framing, struct scene *scene);

/* Places what was added. The camera sees the whole scene from above its front right corner, and the
 * spot beside it lights it. In a room both are inside: the camera at one end of its longest line, the
 * spot below the ceiling. */
void framing_place(const struct framing *framing, struct scene *scene,
                   const struct geometry *geometry);

#endif
