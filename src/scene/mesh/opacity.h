/* Triangles with an alpha mask as opaque parts: 8 x 8 to a triangle, a bit each [Gruen et al. 2020]. Triangles of many
 * texels are cut in four first, at most twice.
 */
#ifndef SCENE_MESH_OPACITY_H
#define SCENE_MESH_OPACITY_H

#include "scene/mesh/cut_triangle.h"

/* All triangles but panes, of those with an alpha mask what it leaves. */
struct triangle_parts opaque_triangles_of(const struct scene *scene,
                                          const struct geometry *geometry);

#endif
