/* Panes as triangles for rays of shaders (glsl/lib/panes.glsl). A transmittance replaces mask and
 * number. With a varying base colour, each part of a triangle has its mean. */
#ifndef SCENE_MESH_PANE_TRIANGLES_H
#define SCENE_MESH_PANE_TRIANGLES_H

#include "scene/mesh/cut_triangle.h"

struct triangle_parts pane_triangles_of(const struct scene *scene, const struct geometry *geometry);

/* Returns the transmittance of panes along a unit direction up to `distance`, metres; 1 without
 * panes. */
vec3s pane_triangles_pass(const struct bvh *panes, vec3s origin, vec3s direction, float distance);

#endif
