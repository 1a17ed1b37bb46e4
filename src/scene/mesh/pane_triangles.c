#include "scene/mesh/pane_triangles.h"

#include "base/halton.h"
#include "base/memory.h"
#include "scene/mesh/corners.h"
#include "shared/panes.h"

#include <math.h>
#include <string.h>

static vec4s mean_color(const struct scene *scene, const struct geometry *geometry,
                        const uint32_t *index, const float decode[256],
                        const struct material *material) {
    enum { PLACES = 16 };
    vec4s sum = glms_vec4_zero();
    for (uint32_t i = 0; i < PLACES; i++) {
        struct corners corners = {{index[0], index[1], index[2]}, {0}};
        corners_spread(corners.weight, radical_inverse(2, i), radical_inverse(3, i));
        sum = glms_vec4_add(sum, corners_base_color(&corners, scene, geometry, decode, material));
    }
    return glms_vec4_scale(sum, 1.F / PLACES);
}

static uint32_t unorm_of(float share) {
    return (uint32_t)lrintf(share * 65535);
}

/* Shares of light that go past it and that enter it, in 16 bits each; the index; the colour. */
static void pack(struct bvh_triangle *triangle, const struct material *material, vec4s color) {
    struct pane_color pane = material_pane_color(material, color);
    float enters = (1 - pane.base) * material_transmits(material);
    float index = material->thin_walled ? pane.index : -pane.index;
    triangle->opaque[0] = unorm_of(pane.base) | unorm_of(enters) << 16;
    memcpy(&triangle->opaque[1], &index, sizeof index);
    triangle->number = material->double_sided || material->transmission > 0 ? PANE_BOTH : 0;
    for (int c = 0; c < 3; c++) {
        float own = enters > 0 ? pane.glass.raw[c] / enters : glm_clamp(color.raw[c], 0, 1);
        triangle->number |= (uint32_t)lrintf(own * PANE_COLOR_MOST) << PANE_COLOR_BITS * c;
    }
}

struct opaque_triangles pane_triangles_of(const struct scene *scene,
                                          const struct geometry *geometry) {
    uint32_t first = geometry->blocking_index_count, count = (geometry->index_count - first) / 3;
    struct opaque_triangles list = {mem_alloc(count, sizeof *list.items), count, count};
    float decode[256];
    texture_decode_table(decode);
    for (int b = geometry->blocking_batch_count; b < geometry->batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        const struct material *material = &scene->materials[batch->material];
        for (uint32_t i = 0; i < batch->index_count; i += 3) {
            const uint32_t *index = &geometry->indices[batch->first_index + i];
            struct bvh_triangle *triangle = &list.items[(batch->first_index - first + i) / 3];
            triangle->corner = corners_edges(geometry, index, triangle->edges);
            pack(triangle, material, mean_color(scene, geometry, index, decode, material));
        }
    }
    return list;
}
