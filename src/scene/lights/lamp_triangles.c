#include "scene/lights/lamp_triangles.h"

#include "base/halton.h"
#include "base/memory.h"
#include "scene/material.h"
#include "scene/texture.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where a textured triangle is looked at; at most so many places of one that looks dark there; and
 * three times the places of all dark triangles of a primitive. */
enum { PLACES = 16, CLOSE_PLACES = 1 << 12, CLOSE_PLACES_OF_ALL = 3 << 21 };

/* Colours that differ by less are one: filters round. */
static const double likeness = 1e-4;

struct source {
    const struct scene *scene;
    const struct primitive *primitive;
    const struct material *material;
    const float *srgb_to_linear;
};

static vec2s uv_at(float (*uvs)[2], const uint32_t index[3], const float weight[3]) {
    vec2s uv = {{0, 0}};
    for (int k = 0; uvs && k < 3; k++)
        for (int c = 0; c < 2; c++)
            uv.raw[c] += weight[k] * uvs[index[k]][c];
    return uv;
}

static vec4s look_up(const struct source *source, int texture, int mapping, const uint32_t index[3],
                     const float weight[3]) {
    return texture < 0 ? glms_vec4_one()
                       : texture_lookup(&source->scene->textures[texture], source->srgb_to_linear,
                                        uv_at(source->primitive->uv[mapping], index, weight));
}

static bool is_hole(const struct source *source, const uint32_t index[3], const float weight[3]) {
    const struct material *material = source->material;
    if (!material->alpha_mask)
        return false;
    float alpha = 0;
    for (int k = 0; k < 3; k++)
        alpha += weight[k] * (source->primitive->color ? source->primitive->color[index[k]][3] : 1);
    alpha *=
        material->base_color[3] * look_up(source, material->base_color_texture, 0, index, weight).a;
    return material_is_hole(material, alpha);
}

/* The mean of the texture over so many places, black in holes; whether all are alike. */
static bool average_places(const struct source *source, const uint32_t index[3], uint32_t places,
                           double mean[3]) {
    const struct material *material = source->material;
    vec3s first = glms_vec3_zero();
    bool alike = true;
    memset(mean, 0, 3 * sizeof *mean);
    for (uint32_t i = 0; i < places; i++) {
        float x = sqrtf(((float)i + .5F) / (float)places), y = (float)radical_inverse(2, i);
        const float weight[3] = {1 - x, x * (1 - y), x * y};
        vec3s texel = glms_vec3(
            look_up(source, material->emission_texture, material->emission_mapping, index, weight));
        if (is_hole(source, index, weight))
            texel = glms_vec3_zero();
        first = i == 0 ? texel : first;
        alike =
            alike && glms_vec3_distance(texel, first) <= (float)likeness * glms_vec3_norm(first);
        for (int c = 0; c < 3; c++)
            mean[c] += (double)texel.raw[c] / places;
    }
    return alike;
}

/* One for each texel of the emission that the triangle covers, so that no small light of a large
 * one is overlooked. */
static uint32_t close_places(const struct source *source, const uint32_t index[3], uint32_t looks) {
    const struct material *material = source->material;
    float(*uvs)[2] = source->primitive->uv[material->emission_mapping];
    if (material->emission_texture < 0 || !uvs)
        return 0;
    const struct bitmap *bitmap = &source->scene->textures[material->emission_texture].bitmap;
    const float *a = uvs[index[0]], *b = uvs[index[1]], *c = uvs[index[2]];
    double area = fabs((double)((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))) / 2;
    double most = fmin(CLOSE_PLACES, (double)CLOSE_PLACES_OF_ALL / source->primitive->index_count);
    most = fmin(most, looks);
    return (uint32_t)fmin(area * bitmap->width * bitmap->height, most);
}

/* Over the triangle; whether it is of one colour. One that looks dark is looked at closely. */
static bool average(const struct source *source, const uint32_t index[3], uint32_t *looks,
                    double radiance[3]) {
    const struct material *material = source->material;
    double mean[3] = {1, 1, 1};
    bool alike = true;
    if (material->emission_texture >= 0 || material->alpha_mask) {
        alike = average_places(source, index, PLACES, mean);
        uint32_t close = mean[0] + mean[1] + mean[2] > 0 ? 0 : close_places(source, index, *looks);
        if (close > PLACES) {
            average_places(source, index, close, mean);
            *looks -= close;
        }
    }
    for (int c = 0; c < 3; c++)
        radiance[c] = (double)material->emission[c] * mean[c];
    return alike;
}

/* False where it has no area. */
static bool place(const struct source *source, const uint32_t index[3], const float world[16],
                  struct lamp_triangle *triangle) {
    double edge[2][3], across[3];
    for (int k = 0; k < 3; k++) {
        const float *p = source->primitive->position[index[k]];
        for (int c = 0; c < 3; c++)
            triangle->corners[k][c] = (double)world[c] * (double)p[0] +
                                      (double)world[4 + c] * (double)p[1] +
                                      (double)world[8 + c] * (double)p[2] + (double)world[12 + c];
    }
    for (int c = 0; c < 3; c++) {
        edge[0][c] = triangle->corners[1][c] - triangle->corners[0][c];
        edge[1][c] = triangle->corners[2][c] - triangle->corners[0][c];
    }
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        across[c] = edge[0][d] * edge[1][e] - edge[0][e] * edge[1][d];
    }
    double length = sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
    triangle->area = length / 2;
    mat3 turn;
    for (int column = 0; column < 3; column++)
        memcpy(turn[column], &world[4 * column], sizeof turn[column]);
    double side = glm_mat3_det(turn) < 0 ? -1 : 1; /* a mirrored surface keeps its front */
    for (int c = 0; c < 3; c++)
        triangle->normal[c] = side * across[c] / length;
    return length > 0 && isfinite(length);
}

static void add(struct lamp_triangles *triangles, const struct lamp_triangle *triangle,
                double side) {
    struct lamp_triangle *to = &triangles->items[triangles->count++];
    *to = *triangle;
    for (int c = 0; c < 3; c++)
        to->normal[c] *= side;
}

void lamp_triangles_add(struct lamp_triangles *triangles, const struct scene *scene,
                        const struct primitive *primitive, const float world[16]) {
    struct source source = {scene, primitive, &scene->materials[primitive->material],
                            triangles->srgb_to_linear};
    size_t most = (size_t)triangles->count + 2 * (size_t)primitive->index_count / 3;
    triangles->items = mem_resize(triangles->items, most, sizeof *triangles->items);
    for (int i = 0; i + 2 < primitive->index_count; i += 3) {
        struct lamp_triangle triangle;
        if (!place(&source, &primitive->indices[i], world, &triangle))
            continue;
        bool alike = average(&source, &primitive->indices[i], &triangles->looks, triangle.radiance);
        bool shines = triangle.radiance[0] + triangle.radiance[1] + triangle.radiance[2] > 0;
        triangles->has_detail |= !alike || !shines;
        if (!shines)
            continue;
        add(triangles, &triangle, 1);
        if (source.material->double_sided)
            add(triangles, &triangle, -1);
    }
}

void lamp_triangle_radiance(const struct scene *scene, const struct primitive *primitive,
                            const uint32_t index[3], const float *srgb_to_linear, uint32_t *looks,
                            double radiance[3]) {
    struct source source = {scene, primitive, &scene->materials[primitive->material],
                            srgb_to_linear};
    average(&source, index, looks, radiance);
}

void lamp_triangles_free(struct lamp_triangles *triangles) {
    free(triangles->items);
    *triangles = (struct lamp_triangles){0};
}

double lamp_triangles_power(const struct lamp_triangles *triangles) {
    double power = 0;
    for (int i = 0; i < triangles->count; i++) {
        const struct lamp_triangle *triangle = &triangles->items[i];
        for (int c = 0; c < 3; c++)
            power += triangle->area * triangle->radiance[c];
    }
    return power;
}

bool lamp_triangles_color(const struct lamp_triangles *triangles, float radiance[3]) {
    const struct lamp_triangle *items = triangles->items;
    bool alike = triangles->count > 0 && !triangles->has_detail;
    for (int i = 3; alike && i < 3 * triangles->count; i++) {
        double first = items->radiance[i % 3];
        alike = fabs(items[i / 3].radiance[i % 3] - first) <= likeness * first;
    }
    for (int c = 0; alike && c < 3; c++)
        radiance[c] = (float)items->radiance[c];
    return alike;
}
