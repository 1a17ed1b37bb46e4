/* Scenes far from the world's origin.
 *
 * Floats are dense near 0: ten kilometres away they are a millimetre apart. Where a scene lies far
 * out compared with its size, its root nodes are moved back, and all that follows sees it there.
 */
#ifndef SCENE_RECENTRE_H
#define SCENE_RECENTRE_H

#include "scene/mesh/geometry.h"

/* Sets scene->origin by the bounds of its geometry, and moves root nodes and their animation by its
 * opposite; the geometry must then be made anew. False where the scene is near enough. */
bool scene_recentre(struct scene *scene, const struct geometry *geometry);

#endif
