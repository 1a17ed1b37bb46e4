#include "scene/mesh/pane_triangles.h"

#include "base/halton.h"
#include "scene/mesh/bvh_ray.h"
#include "scene/mesh/corners.h"
#include "shared/bvh.h"

#include <math.h>
#include <string.h>

enum { PLACES = 16, TEXELS = 16, DEPTH = 5 }; /* of a part; times a triangle is cut at most */

/* Parts of a batch, however few texels they have: colours run smoothly between texels and between
 * vertices. */
enum { PARTS_FEW = 1 << 14 };

/* Differences of base colour that are not worth a cut. */
static const float even = .1F;

/* The mean, by places of the part; whether they are much the same. */
static bool mean_color(const struct cut_triangle *triangle, const struct triangle_part *part,
                       vec4s *mean) {
    vec4s sum = glms_vec4_zero(), least = glms_vec4_one(), most = glms_vec4_zero();
    for (uint32_t i = 0; i < PLACES; i++) {
        float weight[3];
        corners_spread(weight, radical_inverse(2, i), radical_inverse(3, i));
        vec4s color = triangle_color(triangle, triangle_within(part, weight[1], weight[2]));
        sum = glms_vec4_add(sum, color);
        least = glms_vec4_minv(least, color);
        most = glms_vec4_maxv(most, color);
    }
    *mean = glms_vec4_scale(sum, 1.F / PLACES);
    return glms_vec4_max(glms_vec4_sub(most, least)) < even;
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

static void add_part(struct triangle_parts *list, const struct cut_triangle *triangle,
                     const struct triangle_part *part, int depth) {
    vec4s color;
    struct triangle_part quarters[4];
    if (mean_color(triangle, part, &color) || depth == 0) {
        pack(triangle_parts_add(list, triangle, part), triangle->material, color);
        return;
    }
    triangle_quarters(part, quarters);
    for (int q = 0; q < 4; q++)
        add_part(list, triangle, &quarters[q], depth - 1);
}

static int depth_of(const struct cut_triangle *triangle, uint32_t triangles) {
    int by_texels = triangle_depth(triangle, TEXELS, DEPTH), depth = 0;
    while (depth < DEPTH && (uint64_t)triangles << 2 * (depth + 1) <= PARTS_FEW)
        depth++;
    return depth > by_texels ? depth : by_texels;
}

struct triangle_parts pane_triangles_of(const struct scene *scene,
                                        const struct geometry *geometry) {
    struct triangle_parts list = {0};
    struct cut_triangle triangle = {.scene = scene, .geometry = geometry};
    texture_decode_table(triangle.decode);
    for (int b = geometry->blocking_batch_count; b < geometry->batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        triangle.material = &scene->materials[batch->material];
        for (uint32_t i = 0; i < batch->index_count; i += 3) {
            triangle.index = &geometry->indices[batch->first_index + i];
            add_part(&list, &triangle, &triangle_whole,
                     depth_of(&triangle, batch->index_count / 3));
        }
    }
    return list;
}

static vec3s passes(const struct bvh_triangle *triangle, vec3s direction) {
    float base = (float)(triangle->opaque[0] & 0xffff) / 65535;
    float enters = (float)(triangle->opaque[0] >> 16) / 65535, index;
    vec3s normal = vec3s_unit(glms_vec3_cross(triangle->edges[0], triangle->edges[1])), share;
    memcpy(&index, &triangle->opaque[1], sizeof index);
    float plate = enters * material_plate_passes(index, fabsf(glms_vec3_dot(normal, direction)));
    for (int c = 0; c < 3; c++) {
        uint32_t color = triangle->number >> PANE_COLOR_BITS * c & PANE_COLOR_MOST;
        share.raw[c] = base + plate * (float)color / PANE_COLOR_MOST;
    }
    return share;
}

vec3s pane_triangles_pass(const struct bvh *panes, vec3s origin, vec3s direction, float distance) {
    const float edge = 1e-5F; /* parts of a distance: an edge belongs to both its triangles */
    vec3s share = glms_vec3_one();
    for (float from = 0; panes && panes->count > 0 && glms_vec3_max(share) > 0;) {
        vec3s start = glms_vec3_muladds(direction, from, origin);
        struct bvh_hit hit = bvh_ray_trace(panes, start, direction);
        if (!hit.triangle || from + hit.distance > distance)
            break;
        share = glms_vec3_mul(share, passes(hit.triangle, direction));
        from += hit.distance * (1 + edge) + edge * from;
    }
    return share;
}
