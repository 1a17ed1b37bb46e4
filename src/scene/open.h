/* From a file to a scene that can be shown. */
#ifndef SCENE_OPEN_H
#define SCENE_OPEN_H

#include "scene/mesh/geometry.h"

/* Loads the file, lets a clip play (name or number; NULL = the first), lays out the triangles of time
 * 0, moves all to the origin where it lies far out (scene/recentre.h) and gives it the camera and the
 * light that it lacks (scene/framing.h). Triangles are laid out once, of scenes far out twice. Error:
 * names file, object and reason; both are then zeroed. */
bool scene_open(struct scene *scene, struct geometry *geometry, const char *path, const char *clip);

#endif
