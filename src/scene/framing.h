/* A camera and a light for files that bring none. */
#ifndef SCENE_FRAMING_H
#define SCENE_FRAMING_H

#include "scene/scene.h"

/* Adds a camera that sees the whole scene from above its front right corner, and a spot beside it
 * that lights it, each only where the scene has none. In a room both are inside: the camera at one
 * end of its longest line, the spot below the ceiling. Notes it on stderr. Error: a scene without a
 * triangle. */
bool scene_frame(struct scene *scene);

#endif
