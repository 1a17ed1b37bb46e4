#include "scene/mesh/opacity.h"

#include "scene/material.h"
#include "scene/texture.h"
#include "shared/bvh.h"

enum { SIDE = OPACITY_SIDE, DEPTH = 2 }; /* times a triangle is cut at most */

enum fill { FILL_NONE, FILL_SOME, FILL_ALL };

static bool is_opaque(const struct cut_triangle *triangle, vec2s at) {
    return !material_is_hole(triangle->material, triangle_color(triangle, at).a);
}

/* Row by row along the first edge: the parts that lie as the triangle does, and between them those
 * that are turned. */
static enum fill fill_bits(const struct cut_triangle *triangle, const struct triangle_part *part,
                           uint32_t bits[2]) {
    int number = 0, opaque = 0;
    bits[0] = bits[1] = 0;
    for (int row = 0; row < SIDE; row++)
        for (int i = 0; i < 2 * (SIDE - row) - 1; i++, number++) {
            float past = i % 2 ? 2.F / 3 : 1.F / 3;
            vec2s at =
                triangle_within(part, ((float)(i / 2) + past) / SIDE, ((float)row + past) / SIDE);
            bool is = is_opaque(triangle, at);
            bits[number / 32] |= (uint32_t)is << number % 32;
            opaque += is;
        }
    return opaque == 0 ? FILL_NONE : opaque == number ? FILL_ALL : FILL_SOME;
}

static void add(struct triangle_parts *list, const struct cut_triangle *triangle,
                const struct triangle_part *part, const uint32_t bits[2]) {
    struct bvh_triangle *added = triangle_parts_add(list, triangle, part);
    added->opaque[0] = bits[0];
    added->opaque[1] = bits[1];
}

/* What is opaque, or a hole, throughout is not cut. */
static enum fill add_part(struct triangle_parts *list, const struct cut_triangle *triangle,
                          const struct triangle_part *part, int depth) {
    static const uint32_t all[2] = {~0U, ~0U};
    uint32_t bits[2], before = list->count;
    if (depth == 0) {
        enum fill fill = fill_bits(triangle, part, bits);
        if (fill != FILL_NONE)
            add(list, triangle, part, bits);
        return fill;
    }
    struct triangle_part quarters[4];
    int fills[3] = {0};
    triangle_quarters(part, quarters);
    for (int q = 0; q < 4; q++)
        fills[add_part(list, triangle, &quarters[q], depth - 1)]++;
    if (fills[FILL_ALL] == 4) {
        list->count = before;
        add(list, triangle, part, all);
    }
    return fills[FILL_ALL] == 4 ? FILL_ALL : fills[FILL_NONE] == 4 ? FILL_NONE : FILL_SOME;
}

static void add_masked(struct triangle_parts *list, const struct scene *scene,
                       const struct geometry *geometry, const struct geometry_batch *batch) {
    struct cut_triangle triangle = {
        .scene = scene, .geometry = geometry, .material = &scene->materials[batch->material]};
    texture_decode_table(triangle.decode);
    for (uint32_t i = 0; i < batch->index_count; i += 3) {
        triangle.index = &geometry->indices[batch->first_index + i];
        /* A bit stands for about a texel. */
        add_part(list, &triangle, &triangle_whole, triangle_depth(&triangle, SIDE * SIDE, DEPTH));
    }
}

static void add_opaque(struct triangle_parts *list, const struct geometry *geometry,
                       const struct geometry_batch *batch) {
    for (uint32_t i = 0; i < batch->index_count; i += 3) {
        struct bvh_triangle *added =
            triangle_parts_add_whole(list, geometry, &geometry->indices[batch->first_index + i]);
        added->opaque[0] = added->opaque[1] = ~0U;
    }
}

struct triangle_parts opaque_triangles_of(const struct scene *scene,
                                          const struct geometry *geometry) {
    struct triangle_parts list = {0};
    for (int b = 0; b < geometry->blocking_batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        if (scene->materials[batch->material].alpha_mask)
            add_masked(&list, scene, geometry, batch);
        else
            add_opaque(&list, geometry, batch);
    }
    return list;
}
