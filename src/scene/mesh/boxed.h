/* The part of a triangle that lies in a box. */
#ifndef SCENE_MESH_BOXED_H
#define SCENE_MESH_BOXED_H

#include "scene/mesh/corners.h"

struct box {
    float low[3], high[3]; /* metres; infinite: no end */
};

/* Whether the box ends anywhere. */
bool box_ends(const struct box *box);

/* Whether both corners of a smaller box lie in it. */
bool box_holds(const struct box *box, const float low[3], const float high[3]);

/* The part's share of the triangle's area. */
double boxed_share(const struct box *box, const struct geometry *geometry, const uint32_t index[3]);

/* The weights of a place in the part that is uniform where x and y are, in [0, 1): corners_spread's of a triangle that the
 * box holds. False where the triangle has no part in the box. */
bool boxed_spread(float weight[3], const struct box *box, const struct geometry *geometry,
                  const uint32_t index[3], double x, double y);

#endif
