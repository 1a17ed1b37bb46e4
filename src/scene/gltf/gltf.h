/* Loads glTF 2.0 files through tinygltf.
 *
 * Output of tinygltf is not trusted. Files named by a .gltf are read only below a root
 * (scene/read_rules.h). */
#ifndef SCENE_GLTF_GLTF_H
#define SCENE_GLTF_GLTF_H

#include "base/file/file.h"
#include "scene/scene.h"

/* Fills a zeroed scene with the file's contents and path. bytes: contents in place of the file, or
 * NULL. With `bytes`, path gives the folder of named files; without a folder it is only a name for
 * messages. Error: names file and object; the caller must then call scene_free. */
bool gltf_load(struct scene *scene, const char *path, const struct file_bytes *bytes,
               const struct scene_choice *choice);

#endif
