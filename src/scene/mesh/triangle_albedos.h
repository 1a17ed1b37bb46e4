/* What each triangle of a geometry reflects on the mean, for paths of light that know what they meet by its number alone. */
#ifndef SCENE_MESH_TRIANGLE_ALBEDOS_H
#define SCENE_MESH_TRIANGLE_ALBEDOS_H

#include "scene/mesh/corners.h"

struct triangle_albedo {
    float color[3]; /* linear, at most 1 */
    float backs;    /* 1: backs reflect like fronts; 0: they are black */
};

/* Into one for each of the geometry's triangles. */
void triangle_albedos_find(struct triangle_albedo *albedos, const struct surface_colors *colors);

#endif
