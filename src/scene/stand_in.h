/* A few triangles that are drawn by the very programs that a scene is drawn by: for whoever wants those
 * compiled before the scene itself is drawn.
 *
 * Two triangles of each material, across the scene; textures of few texels, which are sampled as the scene's
 * are; the texels of the scene's sky, which must live as long.
 */
#ifndef SCENE_STAND_IN_H
#define SCENE_STAND_IN_H

#include "scene/lights/environment.h"
#include "scene/mesh/geometry.h"

struct stand_in {
    struct scene scene;
    struct geometry geometry;
    struct environment sky; /* the scene's, as it was turned and strong then; with its texels */
};

void stand_in_init(struct stand_in *stand_in, const struct scene *scene,
                   const struct geometry *geometry);

/* Accepts zeroed ones. */
void stand_in_free(struct stand_in *stand_in);

#endif
