/* Mean albedo and specular lobe of each triangle, for light paths that know only the triangle's
 * number. */
#ifndef SCENE_MESH_TRIANGLE_ALBEDOS_H
#define SCENE_MESH_TRIANGLE_ALBEDOS_H

#include "scene/mesh/corners.h"

struct triangle_albedo {
    float color[3];              /* linear, at most 1 */
    float backs;                 /* 1: backs reflect like fronts; 0: backs are black */
    float f0[3], f90, roughness; /* of the part of the colour that is specular; 0: it is diffuse */
};

/* Fills one item for each triangle of the geometry. */
void triangle_albedos_find(struct triangle_albedo *albedos, const struct surface_colors *colors);

#endif
