/* Moves scenes that are far from the world's origin.
 *
 * Floats are dense near 0; at ten kilometres they are a millimetre apart. If a scene is far away
 * compared with its size, its root nodes are moved to the origin. */
#ifndef SCENE_RECENTRE_H
#define SCENE_RECENTRE_H

#include "scene/mesh/geometry.h"

/* Sets scene->origin by the bounds of its geometry. It moves root nodes and their animation by the
 * opposite; the caller must then rebuild the geometry. False: the scene is near enough. */
bool scene_recentre(struct scene *scene, const struct geometry *geometry);

#endif
