/* A few triangles that use exactly the programs of a scene, to compile these before the scene is
 * drawn.
 *
 * It has two triangles of each material across the scene, and small textures with the scene's
 * sampling. It shares the texels of the scene's environment, which must outlive it. */
#ifndef SCENE_STAND_IN_H
#define SCENE_STAND_IN_H

#include "scene/lights/environment.h"
#include "scene/mesh/geometry.h"

struct stand_in {
    struct scene scene;
    struct geometry geometry;
    struct environment sky; /* copy of the scene's turn and strength; shares its texels */
};

void stand_in_init(struct stand_in *stand_in, const struct scene *scene,
                   const struct geometry *geometry);

/* Accepts a zeroed object. */
void stand_in_free(struct stand_in *stand_in);

#endif
