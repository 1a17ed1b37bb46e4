/* Clips triangles to a box. */
#ifndef SCENE_MESH_BOXED_H
#define SCENE_MESH_BOXED_H

#include "scene/mesh/corners.h"

struct box {
    float low[3], high[3]; /* metres; infinite: unbounded */
};

/* True if some side is finite. */
bool box_ends(const struct box *box);

/* True if the box contains both corners of a smaller box. */
bool box_holds(const struct box *box, const float low[3], const float high[3]);

/* Returns the fraction of the triangle's area inside the box. */
double boxed_share(const struct box *box, const struct geometry *geometry, const uint32_t index[3]);

/* Writes barycentric weights of a point inside the box: uniform over the area for uniform x and y
 * in [0, 1). For a triangle inside it equals corners_spread. False: no part of the triangle is
 * inside. */
bool boxed_spread(float weight[3], const struct box *box, const struct geometry *geometry,
                  const uint32_t index[3], double x, double y);

#endif
