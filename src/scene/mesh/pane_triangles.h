/* Panes as triangles for rays of shaders (glsl/lib/panes.glsl): in place of the 64 bits of masks and the number each
 * has what it lets pass. Where the base colour varies, each part of a triangle has its mean.
 */
#ifndef SCENE_MESH_PANE_TRIANGLES_H
#define SCENE_MESH_PANE_TRIANGLES_H

#include "scene/mesh/cut_triangle.h"

struct triangle_parts pane_triangles_of(const struct scene *scene, const struct geometry *geometry);

#endif
