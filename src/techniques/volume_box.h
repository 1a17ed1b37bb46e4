/* The box of a volume of light: the scene's bounds without a few huge triangles, like those of a
 * ground plane around a room. Voxels that cover the plane would be as large as the room. */
#ifndef TECHNIQUES_VOLUME_BOX_H
#define TECHNIQUES_VOLUME_BOX_H

#include "scene/mesh/surface_points.h"

/* Finds the box over the whole clip; the geometry's pose does not matter. An infinite box: the
 * whole scene. */
void volume_box_fit(struct box *box, const struct scene *scene, const struct geometry *geometry);

#endif
