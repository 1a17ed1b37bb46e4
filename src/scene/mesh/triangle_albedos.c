#include "scene/mesh/triangle_albedos.h"

#include "base/halton.h"

#include <math.h>
#include <string.h>

/* Places that share a texture: of a triangle as many as its part of all area, within these. */
enum { PLACES = 1 << 16, PLACES_MOST = 1024 };

struct finder {
    const struct surface_colors *colors;
    double area; /* of all */
};

static uint32_t count_places(const struct finder *finder, const struct material *material,
                             const uint32_t index[3]) {
    bool varies =
        material->base_color_texture >= 0 ||
        (finder->colors->materials == MATERIALS_FULL && material->metal_roughness_texture >= 0);
    if (!varies)
        return 1;
    double share = corners_area(finder->colors->geometry, index) / finder->area;
    return 1 + (uint32_t)fmin(share * PLACES, PLACES_MOST - 1);
}

static struct triangle_albedo mean_of(const struct finder *finder, const struct material *material,
                                      const uint32_t index[3]) {
    struct triangle_albedo sum = {.backs = material->double_sided ? 1 : 0};
    struct corners corners;
    struct reflectance lobe;
    uint32_t places = count_places(finder, material, index);
    float share = 1 / (float)places;
    memcpy(corners.index, index, sizeof corners.index);
    for (uint32_t i = 0; i < places; i++) {
        corners_spread(corners.weight, radical_inverse(2, 1 + i), radical_inverse(3, 1 + i));
        vec4s color = corners_albedo(&corners, finder->colors, material, &lobe);
        glm_vec3_add(sum.color, color.raw, sum.color);
        glm_vec3_muladds(lobe.f0.raw, share, sum.f0);
        sum.f90 += share * lobe.f90;
        sum.roughness += share * lobe.roughness;
    }
    glm_vec3_scale(sum.color, share, sum.color);
    return sum;
}

static void find_in_batch(struct triangle_albedo *albedos, const struct finder *finder,
                          const struct geometry_batch *batch) {
    const struct geometry *geometry = finder->colors->geometry;
    const struct material *material = &finder->colors->scene->materials[batch->material];
    for (uint32_t at = batch->first_index; at < batch->first_index + batch->index_count; at += 3)
        albedos[at / 3] = mean_of(finder, material, &geometry->indices[at]);
}

void triangle_albedos_find(struct triangle_albedo *albedos, const struct surface_colors *colors) {
    const struct geometry *geometry = colors->geometry;
    struct finder finder = {.colors = colors};
    for (uint32_t at = 0; at < geometry->index_count; at += 3)
        finder.area += corners_area(geometry, &geometry->indices[at]);
    for (int b = 0; b < geometry->batch_count; b++)
        find_in_batch(albedos, &finder, &geometry->batches[b]);
}
