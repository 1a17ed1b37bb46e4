/* A hash of all inputs of a picture of a scene. Equal inputs have equal hashes; unequal ones almost
 * surely differ. */
#ifndef SCENE_HASH_H
#define SCENE_HASH_H

#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Hashes triangles, materials, textures, camera and lights in their current pose. */
uint64_t scene_hash(const struct scene *scene, const struct geometry *geometry,
                    const struct camera *camera, const struct emitters *emitters);

/* Adds more bytes to the hash: FNV-1a. */
void hash_bytes(uint64_t *sum, const void *bytes, size_t size);

#endif
