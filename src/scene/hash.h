/* A number for all that a picture of a scene depends on: equal where the pictures must be, and all but
 * surely another where anything differs. */
#ifndef SCENE_HASH_H
#define SCENE_HASH_H

#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Triangles, materials, textures, camera and lights as they are posed. */
uint64_t scene_hash(const struct scene *scene, const struct geometry *geometry,
                    const struct camera *camera, const struct emitters *emitters);

/* Goes on with more bytes: FNV-1a. */
void hash_bytes(uint64_t *sum, const void *bytes, size_t size);

#endif
