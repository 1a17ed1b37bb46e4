/* Panes as triangles for rays of shaders (glsl/lib/panes.glsl): in place of the 64 bits of masks and the number each
 * has what it lets pass. Where the base colour varies, each part of a triangle has its mean.
 */
#ifndef SCENE_MESH_PANE_TRIANGLES_H
#define SCENE_MESH_PANE_TRIANGLES_H

#include "scene/mesh/cut_triangle.h"

struct triangle_parts pane_triangles_of(const struct scene *scene, const struct geometry *geometry);

/* What panes let pass of light along a unit direction, up to a distance: all where there are none. */
vec3s pane_triangles_pass(const struct bvh *panes, vec3s origin, vec3s direction, float distance);

#endif
