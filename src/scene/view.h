/* The views that passes draw: of a camera, and from a light (shared/view.h, shared/light.h). */
#ifndef SCENE_VIEW_H
#define SCENE_VIEW_H

#include "scene/camera.h"
#include "scene/mesh/geometry.h"
#include "scene/emitter.h"
#include "shared/light.h"

/* aspect = width / height. The near plane lies at a millionth of the scene's size. */
void view_of_camera(struct view *view, const struct camera *camera, const struct geometry *geometry,
                    float aspect);

/* One perspective view of a spot, six along the world's axes of a point light (and of a spot wider
 * than 2 x 60 degrees), one orthographic view over the scene's bounds of a directional light. */
void view_of_emitter(struct light_block *block, const struct emitter *light,
                     const struct geometry *geometry);

/* How many views: 1 or 6. */
int emitter_view_count(const struct emitter *light);

#endif
