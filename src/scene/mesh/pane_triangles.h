/* Panes as triangles for rays of shaders (glsl/lib/panes.glsl): in place of the 64 bits of masks and the number each
 * has what it lets pass, by the mean of its base colour.
 */
#ifndef SCENE_MESH_PANE_TRIANGLES_H
#define SCENE_MESH_PANE_TRIANGLES_H

#include "scene/mesh/opacity.h"

struct opaque_triangles pane_triangles_of(const struct scene *scene,
                                          const struct geometry *geometry);

#endif
