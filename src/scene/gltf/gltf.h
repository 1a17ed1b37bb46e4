/* glTF 2.0 files through tinygltf.
 *
 * tinygltf parses; nothing it hands out is trusted. Files that a .gltf names are read only from below
 * a root: scene/read_rules.h.
 */
#ifndef SCENE_GLTF_GLTF_H
#define SCENE_GLTF_GLTF_H

#include "scene/scene.h"

/* Fills a zeroed scene with what the file holds, and its path. On an error, which names file and
 * object, the scene is left half-built for scene_free. */
bool gltf_load(struct scene *scene, const char *path);

#endif
