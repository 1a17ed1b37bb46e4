/* Encodes a scene of arrays as a GLB in memory, so arrays pass the same checks and repairs as
 * files. */
#ifndef LIBRARY_ARRAYS_H
#define LIBRARY_ARRAYS_H

#include "base/file/file.h"
#include "library/manylight.h"

/* Encodes the arrays of desc. The caller frees bytes->data with free(). Error: names the mesh,
 * light or member that a GLB cannot hold. */
bool arrays_to_glb(const struct manylight_scene_desc *desc, struct file_bytes *bytes);

#endif
