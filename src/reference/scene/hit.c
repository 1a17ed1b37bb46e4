#include "reference/scene/hit.h"

#include "reference/vector.h"
#include "scene/mesh/corners.h"

#include <math.h>

static struct corners find_corners(const struct hit_table *table,
                                   const struct triangle_point *point) {
    const uint32_t *index = &table->geometry->indices[3 * (size_t)point->triangle];
    return (struct corners){{index[0], index[1], index[2]},
                            {1 - point->u - point->v, point->u, point->v}};
}

vec3s hit_winding_normal(const struct hit_table *table, uint32_t triangle) {
    vec3s edges[2];
    corners_edges(table->geometry, &table->geometry->indices[3 * (size_t)triangle], edges);
    return vec3s_unit_cross(edges[0], edges[1]);
}

static vec4s base_color(const struct hit_table *table, const struct material *material,
                        const struct corners *corners) {
    return corners_base_color(corners, table->scene, table->geometry, table->srgb_to_linear,
                              material);
}

static vec3s texel_of(const struct hit_table *table, const struct corners *corners, int texture,
                      int mapping) {
    return glms_vec3(corners_texel(corners, table->scene, table->geometry, table->srgb_to_linear,
                                   &(struct corners_texture){texture, mapping}));
}

static vec3s emission_at(const struct hit_table *table, const struct material *material,
                         const struct corners *corners) {
    vec3s emission = vector_of(material->emission);
    if (material->emission_texture < 0)
        return emission;
    return glms_vec3_mul(
        emission, texel_of(table, corners, material->emission_texture, material->emission_mapping));
}

/* Along u and against v of a mapping, in the plane of the triangle; zero where its uv have
 * no area. */
static void tangents_of(const struct geometry *geometry, int mapping, const uint32_t index[3],
                        vec3s *along_u, vec3s *against_v) {
    vec3s edges[2];
    float uv[2][2] = {{0}};
    float(*uvs)[2] = geometry->uv[mapping];
    corners_edges(geometry, index, edges);
    for (int i = 0; uvs && i < 2; i++)
        for (int c = 0; c < 2; c++)
            uv[i][c] = uvs[index[i + 1]][c] - uvs[index[0]][c];
    float side = copysignf(1, uv[0][0] * uv[1][1] - uv[1][0] * uv[0][1]);
    *along_u =
        glms_vec3_muladds(edges[0], side * uv[1][1], glms_vec3_scale(edges[1], -side * uv[0][1]));
    *against_v =
        glms_vec3_muladds(edges[0], side * uv[1][0], glms_vec3_scale(edges[1], -side * uv[0][0]));
}

/* As the material's normal map turns it, on the front. */
static vec3s mapped_normal(const struct hit_table *table, const struct material *material,
                           const struct corners *corners, vec3s normal) {
    vec3s read = texel_of(table, corners, material->normal_texture, material->normal_mapping);
    vec3s right, up;
    float x = material->normal_scale * (2 * read.x - 1);
    float y = material->normal_scale * (2 * read.y - 1), z = 2 * read.z - 1;
    tangents_of(table->geometry, material->normal_mapping, corners->index, &right, &up);
    right = vec3s_unit(glms_vec3_muladds(normal, -glms_vec3_dot(normal, right), right));
    vec3s across = glms_vec3_cross(normal, right);
    across = glms_vec3_scale(across, copysignf(1, glms_vec3_dot(across, up)));
    vec3s turned =
        glms_vec3_muladds(right, x, glms_vec3_muladds(across, y, glms_vec3_scale(normal, z)));
    bool is_told = glms_vec3_norm2(right) > 0 && glms_vec3_norm2(turned) > 0;
    return is_told ? vec3s_unit(turned) : normal;
}

static bool is_pane(const struct hit_table *table, const struct material *material) {
    return material_lets_pass(material) &&
           !(table->has_smooth && material_smooth_kind(material) == SMOOTH_GLASS);
}

static struct brdf reflection_at(const struct hit_table *table, const struct material *material,
                                 const struct corners *corners, float cosine) {
    vec3s color = glms_vec3(base_color(table, material, corners));
    bool is_glass = is_pane(table, material);
    if (is_glass)
        color = glms_vec3_scale(color, 1 - material_transmits(material));
    if (!table->has_specular)
        return brdf_lambertian(color);
    struct reflectance at = corners_reflectance(corners, table->scene, table->geometry,
                                                table->srgb_to_linear, material);
    if (is_glass && material_transmits(material) > 0) {
        at.f90 = 1 - material_pane_passes(material, cosine);
        at.f0 = glms_vec3_fill(at.f90);
    }
    return brdf_of(material, color, &at);
}

const struct material *hit_material(const struct hit_table *table, uint32_t triangle) {
    const struct geometry *geometry = table->geometry;
    int low = 0, high = geometry->batch_count - 1;
    while (low < high) {
        int middle = (low + high + 1) / 2;
        if (geometry->batches[middle].first_index <= 3 * triangle)
            low = middle;
        else
            high = middle - 1;
    }
    return &table->scene->materials[geometry->batches[low].material];
}

void hit_table_init(struct hit_table *table, const struct scene *scene,
                    const struct geometry *geometry, enum materials materials) {
    *table = (struct hit_table){
        .scene = scene,
        .geometry = geometry,
        .materials = materials,
    };
    texture_decode_table(table->srgb_to_linear);
    for (int b = 0; b < geometry->batch_count && materials == MATERIALS_FULL; b++)
        table->has_specular |=
            !material_is_diffuse(&scene->materials[geometry->batches[b].material]);
}

bool hit_table_find_smooth(struct hit_table *table) {
    const struct geometry *geometry = table->geometry;
    for (int b = 0; b < geometry->batch_count && table->materials == MATERIALS_FULL; b++)
        table->has_smooth |=
            geometry->batches[b].index_count > 0 &&
            material_smooth_kind(&table->scene->materials[geometry->batches[b].material]);
    table->has_specular |= table->has_smooth;
    return table->has_smooth;
}

/* Whether that side of the material is glass or a mirror. */
static bool is_smooth(const struct hit_table *table, const struct material *material,
                      bool from_behind) {
    enum smooth_kind kind = table->has_smooth ? material_smooth_kind(material) : SMOOTH_NONE;
    return kind == SMOOTH_GLASS ||
           (kind == SMOOTH_MIRROR && (!from_behind || material->double_sided));
}

static bool has_two_sides(const struct hit_table *table, const struct material *material) {
    return material->double_sided || (is_pane(table, material) && material->transmission > 0);
}

void hit_at(const struct hit_table *table, const struct triangle_point *point, vec3s ray_direction,
            struct hit *hit) {
    const struct geometry *geometry = table->geometry;
    const struct material *material = hit_material(table, point->triangle);
    struct corners corners = find_corners(table, point);
    vec3s front = hit_winding_normal(table, point->triangle);
    bool from_behind = glms_vec3_dot(front, ray_direction) > 0;
    float side = from_behind ? -1 : 1;
    hit->position = corners_vector(&corners, geometry->position);
    hit->geometric_normal = glms_vec3_scale(front, side);
    hit->normal = glms_vec3_scale(vec3s_unit(corners_vector(&corners, geometry->normal)), side);
    hit->triangle = point->triangle;
    hit->is_back = from_behind;
    hit->towards = glms_vec3_negate(ray_direction);
    hit->brdf = brdf_lambertian(glms_vec3_zero());
    hit->emission = hit->unlit = glms_vec3_zero();
    hit->smooth = is_smooth(table, material, from_behind) ? material : NULL;
    if (from_behind && !has_two_sides(table, material) && !hit->smooth)
        return;
    bool full = table->materials == MATERIALS_FULL;
    if (full && material->normal_texture >= 0) {
        vec3s front_normal = glms_vec3_scale(hit->normal, side);
        hit->normal = glms_vec3_scale(mapped_normal(table, material, &corners, front_normal), side);
    }
    if (full && material->unlit)
        hit->unlit = glms_vec3(base_color(table, material, &corners));
    else if (hit->smooth)
        hit->tint = glms_vec3(base_color(table, material, &corners));
    else
        hit->brdf =
            reflection_at(table, material, &corners, glms_vec3_dot(hit->normal, hit->towards));
    brdf_turn(&hit->brdf, hit->normal, hit->towards);
    if (from_behind && !has_two_sides(table, material))
        return;
    if (glm_vec3_max((float *)material->emission) > 0)
        hit->emission = emission_at(table, material, &corners);
}

vec3s hit_position(const struct hit_table *table, const struct triangle_point *point) {
    struct corners corners = find_corners(table, point);
    return corners_vector(&corners, table->geometry->position);
}

vec3s hit_emission(const struct hit_table *table, const struct triangle_point *point) {
    struct corners corners = find_corners(table, point);
    return hit_is_hole(table, point)
               ? glms_vec3_zero()
               : emission_at(table, hit_material(table, point->triangle), &corners);
}

bool hit_is_hole(const struct hit_table *table, const struct triangle_point *point) {
    const struct material *material = hit_material(table, point->triangle);
    struct corners corners = find_corners(table, point);
    return material->alpha_mask && !material->blends &&
           material_is_hole(material, base_color(table, material, &corners).a);
}

bool hit_is_pane(const struct hit_table *table, uint32_t triangle) {
    return is_pane(table, hit_material(table, triangle));
}

struct passing hit_passing(const struct hit_table *table, const struct triangle_point *point,
                           vec3s ray_direction) {
    struct corners corners = find_corners(table, point);
    const struct material *material = hit_material(table, point->triangle);
    float cosine = fabsf(glms_vec3_dot(hit_winding_normal(table, point->triangle), ray_direction));
    return material_passing(material, base_color(table, material, &corners), cosine);
}

bool hit_is_hidden(const struct hit_table *table, uint32_t triangle, vec3s ray_direction) {
    const struct material *material = hit_material(table, triangle);
    return !has_two_sides(table, material) && !is_smooth(table, material, true) &&
           glms_vec3_dot(hit_winding_normal(table, triangle), ray_direction) > 0;
}
