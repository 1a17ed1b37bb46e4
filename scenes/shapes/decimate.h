/* Fewer triangles for the same shape. */
#ifndef SCENES_DECIMATE_H
#define SCENES_DECIMATE_H

#include "scene/shapes/surface.h"

/* Down to triangle_count, even where the surface is closed, or to where no edge may go any more
 * (scene/mesh/simplify.h). The vertices that are left stay where they are, normals too. */
void decimate(struct surface *surface, uint32_t triangle_count);

#endif
