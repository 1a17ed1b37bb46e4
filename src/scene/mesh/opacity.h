/* Opacity of masked triangles: 8 x 8 parts with a bit each [Gruen et al. 2020]. Triangles of many
 * texels are first cut in four, at most twice. */
#ifndef SCENE_MESH_OPACITY_H
#define SCENE_MESH_OPACITY_H

#include "scene/mesh/cut_triangle.h"

/* Returns all triangles except panes, without fully transparent parts. */
struct triangle_parts opaque_triangles_of(const struct scene *scene,
                                          const struct geometry *geometry);

#endif
