/* A point of a triangle, and the interpolated attributes of its vertices. */
#ifndef SCENE_MESH_CORNERS_H
#define SCENE_MESH_CORNERS_H

#include "scene/material.h"
#include "scene/mesh/geometry.h"
#include "scene/texture.h"

/* Vertex indices and barycentric weights, sum 1. */
struct corners {
    uint32_t index[3];
    float weight[3];
};

/* Returns the triangle's first corner; `edges` leads to the two others. */
vec3s corners_edges(const struct geometry *geometry, const uint32_t index[3], vec3s edges[2]);

/* Returns the triangle's area, m2. */
double corners_area(const struct geometry *geometry, const uint32_t index[3]);

/* Writes the weights of a point, uniform over the triangle for uniform x and y in [0, 1). */
void corners_spread(float weight[3], double x, double y);

/* Interpolates positions or normals; normals come out shorter than 1 if they differ. */
vec3s corners_vector(const struct corners *corners, float (*vectors)[3]);

/* Returns linear RGBA of a scene texture by a mapping; white for texture -1. srgb_to_linear: table
 * of texture_decode_table. */
struct corners_texture {
    int texture, mapping;
};
vec4s corners_texel(const struct corners *corners, const struct scene *scene,
                    const struct geometry *geometry, const float srgb_to_linear[256],
                    const struct corners_texture *of);

/* Returns base colour factor x texture x vertex colour, linear; A is compared by alpha masks. */
vec4s corners_base_color(const struct corners *corners, const struct scene *scene,
                         const struct geometry *geometry, const float srgb_to_linear[256],
                         const struct material *material);

/* Colours of surfaces that have one colour each. */
struct surface_colors {
    const struct scene *scene;
    const struct geometry *geometry;
    enum materials materials;
    bool smooth_black; /* glass and mirrors have albedo 0, because caustics carry their light */
    float srgb_to_linear[256];
};

/* Returns the total albedo, or the base colour with MATERIALS_DIFFUSE, in [0, 1]; A as in
 * corners_base_color. lobe: set to its specular part, zeroed without one; may be NULL. */
vec4s corners_albedo(const struct corners *corners, const struct surface_colors *colors,
                     const struct material *material, struct reflectance *lobe);

struct reflectance corners_reflectance(const struct corners *corners, const struct scene *scene,
                                       const struct geometry *geometry,
                                       const float srgb_to_linear[256],
                                       const struct material *material);

#endif
