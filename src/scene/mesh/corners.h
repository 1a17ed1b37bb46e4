/* A point of a triangle, and what its three vertices have there. */
#ifndef SCENE_MESH_CORNERS_H
#define SCENE_MESH_CORNERS_H

#include "scene/material.h"
#include "scene/mesh/geometry.h"
#include "scene/texture.h"

/* The vertices' numbers, and their weights: sum 1. */
struct corners {
    uint32_t index[3];
    float weight[3];
};

/* The first corner of the triangle of these vertices, and the edges from it to the two others. */
vec3s corners_edges(const struct geometry *geometry, const uint32_t index[3], vec3s edges[2]);

/* m2 */
double corners_area(const struct geometry *geometry, const uint32_t index[3]);

/* The weights of a place in a triangle that is uniform where x and y are, in [0, 1). */
void corners_spread(float weight[3], double x, double y);

/* Of positions or normals; these come out shorter than 1 where they differ. */
vec3s corners_vector(const struct corners *corners, float (*vectors)[3]);

/* Linear RGBA of one of the scene's textures, by a mapping; white where it is -1. srgb_to_linear:
 * texture_decode_table's. */
struct corners_texture {
    int texture, mapping;
};
vec4s corners_texel(const struct corners *corners, const struct scene *scene,
                    const struct geometry *geometry, const float srgb_to_linear[256],
                    const struct corners_texture *of);

/* Base colour factor x texture x vertex colour, linear; A is what an alpha mask compares. */
vec4s corners_base_color(const struct corners *corners, const struct scene *scene,
                         const struct geometry *geometry, const float srgb_to_linear[256],
                         const struct material *material);

/* How surfaces count where each has one colour. */
struct surface_colors {
    const struct scene *scene;
    const struct geometry *geometry;
    enum materials materials;
    bool smooth_black; /* glass and mirrors reflect nothing: caustics carry their light */
    float srgb_to_linear[256];
};

/* All that the material reflects there, or with MATERIALS_DIFFUSE its base colour, in [0, 1]; A as of
 * corners_base_color. */
vec4s corners_albedo(const struct corners *corners, const struct surface_colors *colors,
                     const struct material *material);

struct reflectance corners_reflectance(const struct corners *corners, const struct scene *scene,
                                       const struct geometry *geometry,
                                       const float srgb_to_linear[256],
                                       const struct material *material);

#endif
