#include "scene/mesh/corners.h"

#include <math.h>
#include <string.h>

vec3s corners_edges(const struct geometry *geometry, const uint32_t index[3], vec3s edges[2]) {
    vec3s corner[3];
    for (int k = 0; k < 3; k++)
        memcpy(corner[k].raw, geometry->position[index[k]], sizeof corner[k].raw);
    for (int e = 0; e < 2; e++)
        edges[e] = glms_vec3_sub(corner[e + 1], corner[0]);
    return corner[0];
}

double corners_area(const struct geometry *geometry, const uint32_t index[3]) {
    vec3s edges[2];
    corners_edges(geometry, index, edges);
    return (double)glms_vec3_norm(glms_vec3_cross(edges[0], edges[1])) / 2;
}

void corners_spread(float weight[3], double x, double y) {
    double root = sqrt(x);
    weight[0] = (float)(1 - root);
    weight[1] = (float)(root * (1 - y));
    weight[2] = (float)(root * y);
}

vec3s corners_vector(const struct corners *corners, float (*vectors)[3]) {
    vec3s sum = glms_vec3_zero();
    for (int k = 0; k < 3; k++) {
        const float *v = vectors[corners->index[k]];
        sum = glms_vec3_muladds((vec3s){{v[0], v[1], v[2]}}, corners->weight[k], sum);
    }
    return sum;
}

static vec4s interpolate_color(const struct corners *corners, const struct geometry *geometry) {
    vec4s sum = {{0, 0, 0, 0}};
    for (int k = 0; k < 3; k++) {
        const float *color = geometry_color(geometry, corners->index[k]);
        sum = glms_vec4_muladds((vec4s){{color[0], color[1], color[2], color[3]}},
                                corners->weight[k], sum);
    }
    return sum;
}

static vec2s interpolate_uv(const struct corners *corners, float (*uvs)[2]) {
    vec2s sum = {{0, 0}};
    for (int k = 0; uvs && k < 3; k++) {
        const float *uv = uvs[corners->index[k]];
        sum = glms_vec2_muladds((vec2s){{uv[0], uv[1]}}, corners->weight[k], sum);
    }
    return sum;
}

vec4s corners_texel(const struct corners *corners, const struct scene *scene,
                    const struct geometry *geometry, const float srgb_to_linear[256],
                    const struct corners_texture *of) {
    if (of->texture < 0)
        return glms_vec4_one();
    return texture_lookup(&scene->textures[of->texture], srgb_to_linear,
                          interpolate_uv(corners, geometry->uv[of->mapping]));
}

vec4s corners_base_color(const struct corners *corners, const struct scene *scene,
                         const struct geometry *geometry, const float srgb_to_linear[256],
                         const struct material *material) {
    const float *factor = material->base_color;
    vec4s color = glms_vec4_mul(interpolate_color(corners, geometry),
                                (vec4s){{factor[0], factor[1], factor[2], factor[3]}});
    if (material->base_color_texture < 0)
        return color;
    return glms_vec4_mul(color,
                         corners_texel(corners, scene, geometry, srgb_to_linear,
                                       &(struct corners_texture){material->base_color_texture, 0}));
}

struct reflectance corners_reflectance(const struct corners *corners, const struct scene *scene,
                                       const struct geometry *geometry,
                                       const float srgb_to_linear[256],
                                       const struct material *material) {
    if (material->metal_roughness_texture < 0)
        return material_reflectance(material);
    return material_reflectance_at(
        material, corners_texel(corners, scene, geometry, srgb_to_linear,
                                &(struct corners_texture){material->metal_roughness_texture,
                                                          material->metal_roughness_mapping}));
}

vec4s corners_albedo(const struct corners *corners, const struct surface_colors *colors,
                     const struct material *material, struct reflectance *lobe) {
    const struct scene *scene = colors->scene;
    const struct geometry *geometry = colors->geometry;
    const float *table = colors->srgb_to_linear;
    if (lobe)
        *lobe = (struct reflectance){0};
    vec4s base = corners_base_color(corners, scene, geometry, table, material);
    vec3s color = glms_vec3(base);
    if (colors->smooth_black && material_smooth_kind(material) != SMOOTH_NONE)
        return glms_vec4(glms_vec3_zero(), base.w);
    if (colors->materials == MATERIALS_FULL) {
        struct reflectance at = corners_reflectance(corners, scene, geometry, table, material);
        if (lobe && !material->unlit && !material_is_diffuse(material))
            *lobe = reflectance_lobe(&at, color);
        color = material_reflects(material, color, &at);
    }
    return glms_vec4(glms_vec3_clamp(color, 0, 1), base.w);
}
