/* Finds vertices at equal positions. Files split corners of adjacent triangles if normals or
 * texture coordinates differ. */
#ifndef SCENE_MESH_WELD_H
#define SCENE_MESH_WELD_H

#include "scene/mesh/geometry.h"

/* Writes for each vertex the first one at its position. */
void weld_vertices(float (*position)[3], uint32_t count, uint32_t *first);

/* Returns for each vertex whether another part has one at its position. It marks this vertex and
 * the first one of all parts at the position. The caller frees the result. */
bool *weld_find_shared(const struct geometry *geometry);

#endif
