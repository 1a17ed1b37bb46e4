/* The box that a volume of light holds: that of the scene, but for a few huge triangles, as of a plain on which a room
 * stands. Voxels that held all of the plain would hold the room whole. */
#ifndef TECHNIQUES_VOLUME_BOX_H
#define TECHNIQUES_VOLUME_BOX_H

#include "scene/mesh/surface_points.h"

struct volume_box {
    float low[3], high[3]; /* metres; infinite: all of the scene */
};

/* Of a scene throughout the clip that plays: the geometry's pose does not matter. */
void volume_box_fit(struct volume_box *box, const struct scene *scene,
                    const struct geometry *geometry);

/* Whether it is less than the scene. */
bool volume_box_cuts(const struct volume_box *box);

#endif
