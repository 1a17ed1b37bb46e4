/* The box that a volume of light holds: that of the scene, but for a few huge triangles, as of a plain on which a room
 * stands. Voxels that held all of the plain would hold the room whole. */
#ifndef TECHNIQUES_VOLUME_BOX_H
#define TECHNIQUES_VOLUME_BOX_H

#include "scene/mesh/surface_points.h"

/* Endless: all of the scene. Of a scene throughout the clip that plays: the geometry's pose does not matter. */
void volume_box_fit(struct box *box, const struct scene *scene, const struct geometry *geometry);

#endif
