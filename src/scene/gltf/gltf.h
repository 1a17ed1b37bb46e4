/* glTF 2.0 files through tinygltf.
 *
 * tinygltf parses; nothing it hands out is trusted. Files that a .gltf names are read only from below
 * a root: scene/read_rules.h.
 */
#ifndef SCENE_GLTF_GLTF_H
#define SCENE_GLTF_GLTF_H

#include "base/file/file.h"
#include "scene/scene.h"

/* Fills a zeroed scene with what the file holds, and its path. bytes: what the file would hold, or NULL; path then tells the
 * folder, and without a folder it is a name for messages. On an error, which names file and
 * object, the scene is left half-built for scene_free. */
bool gltf_load(struct scene *scene, const char *path, const struct file_bytes *bytes,
               const struct scene_choice *choice);

#endif
