/* A point of a triangle, and what its three vertices have there. */
#ifndef SCENE_MESH_CORNERS_H
#define SCENE_MESH_CORNERS_H

#include "scene/mesh/geometry.h"
#include "scene/texture.h"

/* The vertices' numbers, and their weights: sum 1. */
struct corners {
    uint32_t index[3];
    float weight[3];
};

/* Of positions or normals; these come out shorter than 1 where they differ. */
vec3s corners_vector(const struct corners *corners, float (*vectors)[3]);

vec2s corners_uv(const struct corners *corners, float (*uvs)[2]);

/* Base colour factor x texture x vertex colour, linear; A is what an alpha mask compares.
 * srgb_to_linear: texture_decode_table's. */
vec4s corners_base_color(const struct corners *corners, const struct scene *scene,
                         const struct geometry *geometry, const float srgb_to_linear[256],
                         const struct material *material);

#endif
