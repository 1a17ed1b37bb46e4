/* Scenes that callers give as arrays, as a GLB in memory: all that is checked and mended in files is so here. */
#ifndef LIBRARY_ARRAYS_H
#define LIBRARY_ARRAYS_H

#include "base/file/file.h"
#include "library/manylight.h"

/* free() frees bytes->data. Error: names the mesh, the light or the member that a GLB cannot hold. */
bool arrays_to_glb(const struct manylight_scene_desc *desc, struct file_bytes *bytes);

#endif
