/* Coarser casters: vertices of one part that share a cell of a grid become one [Rossignac and
 * Borrel 1993]. A map of 256 x 256 texels cannot show triangles smaller than the cell, but would
 * transform them for each of its layers. */
#ifndef SCENE_WELD_H
#define SCENE_WELD_H

#include "scene/geometry.h"

/* For each vertex the first one of its part within the same cell of this size, in metres, or
 * smaller in small parts; to be freed. */
uint32_t *weld_vertices(const struct geometry *geometry, float cell);

#endif
