#include "scene/mesh/opacity.h"

#include "base/memory.h"
#include "scene/mesh/corners.h"
#include "shared/bvh.h"

#include <math.h>

enum { SIDE = OPACITY_SIDE, DEPTH = 2 }; /* times a triangle is cut at most */

enum fill { FILL_NONE, FILL_SOME, FILL_ALL };

/* A triangle of the geometry. */
struct masked {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct material *material;
    const uint32_t *index;
    float decode[256];
};

/* A part of it, by the weights of the triangle's second and third corner at its own. */
struct part {
    vec2s at[3];
};

static struct corners corners_at(const struct masked *masked, vec2s at) {
    const uint32_t *index = masked->index;
    return (struct corners){{index[0], index[1], index[2]}, {1 - at.x - at.y, at.x, at.y}};
}

static bool is_opaque(const struct masked *masked, vec2s at) {
    struct corners corners = corners_at(masked, at);
    return !material_is_hole(masked->material,
                             corners_base_color(&corners, masked->scene, masked->geometry,
                                                masked->decode, masked->material)
                                 .a);
}

static vec2s within(const struct part *part, float u, float v) {
    vec2s at = glms_vec2_scale(part->at[0], 1 - u - v);
    at = glms_vec2_muladds(part->at[1], u, at);
    return glms_vec2_muladds(part->at[2], v, at);
}

/* Row by row along the first edge: the parts that lie as the triangle does, and between them those that are turned. */
static enum fill fill_bits(const struct masked *masked, const struct part *part, uint32_t bits[2]) {
    int number = 0, opaque = 0;
    bits[0] = bits[1] = 0;
    for (int row = 0; row < SIDE; row++)
        for (int i = 0; i < 2 * (SIDE - row) - 1; i++, number++) {
            float past = i % 2 ? 2.F / 3 : 1.F / 3;
            vec2s at = within(part, ((float)(i / 2) + past) / SIDE, ((float)row + past) / SIDE);
            bool is = is_opaque(masked, at);
            bits[number / 32] |= (uint32_t)is << number % 32;
            opaque += is;
        }
    return opaque == 0 ? FILL_NONE : opaque == number ? FILL_ALL : FILL_SOME;
}

static void append(struct opaque_triangles *list, const struct bvh_triangle *triangle) {
    if (list->count == list->room) {
        list->room = list->room ? 2 * list->room : 1024;
        list->items = mem_resize(list->items, list->room, sizeof *list->items);
    }
    list->items[list->count++] = *triangle;
}

static void add(struct opaque_triangles *list, const struct masked *masked, const struct part *part,
                const uint32_t bits[2]) {
    vec3s places[3];
    for (int k = 0; k < 3; k++) {
        struct corners corners = corners_at(masked, part->at[k]);
        places[k] = corners_vector(&corners, masked->geometry->position);
    }
    uint32_t number = (uint32_t)(masked->index - masked->geometry->indices) / 3;
    append(list,
           &(struct bvh_triangle){
               .corner = places[0],
               .edges = {glms_vec3_sub(places[1], places[0]), glms_vec3_sub(places[2], places[0])},
               .opaque = {bits[0], bits[1]},
               .number = number,
           });
}

/* What is opaque, or a hole, throughout is not cut. */
static enum fill add_part(struct opaque_triangles *list, const struct masked *masked,
                          const struct part *part, int depth) {
    static const uint32_t all[2] = {~0U, ~0U};
    uint32_t bits[2], before = list->count;
    if (depth == 0) {
        enum fill fill = fill_bits(masked, part, bits);
        if (fill != FILL_NONE)
            add(list, masked, part, bits);
        return fill;
    }
    vec2s middle[3];
    int fills[3] = {0};
    for (int k = 0; k < 3; k++)
        middle[k] = glms_vec2_lerp(part->at[k], part->at[(k + 1) % 3], .5F);
    const struct part quarters[4] = {{{part->at[0], middle[0], middle[2]}},
                                     {{middle[0], part->at[1], middle[1]}},
                                     {{middle[2], middle[1], part->at[2]}},
                                     {{middle[1], middle[2], middle[0]}}};
    for (int q = 0; q < 4; q++)
        fills[add_part(list, masked, &quarters[q], depth - 1)]++;
    if (fills[FILL_ALL] == 4) {
        list->count = before;
        add(list, masked, part, all);
    }
    return fills[FILL_ALL] == 4 ? FILL_ALL : fills[FILL_NONE] == 4 ? FILL_NONE : FILL_SOME;
}

/* So that a bit stands for about a texel. */
static int depth_of(const struct masked *masked) {
    if (masked->material->base_color_texture < 0)
        return 0;
    const struct bitmap *bitmap =
        &masked->scene->textures[masked->material->base_color_texture].bitmap;
    vec2s uv[3];
    for (int k = 0; k < 3; k++) {
        const float *at = masked->geometry->uv[0][masked->index[k]];
        uv[k] = (vec2s){{at[0] * (float)bitmap->width, at[1] * (float)bitmap->height}};
    }
    float texels =
        fabsf(glms_vec2_cross(glms_vec2_sub(uv[1], uv[0]), glms_vec2_sub(uv[2], uv[0])) / 2);
    int depth = 0;
    for (float bits = SIDE * SIDE; depth < DEPTH && bits < texels; bits *= 4)
        depth++;
    return depth;
}

static void add_masked(struct opaque_triangles *list, const struct scene *scene,
                       const struct geometry *geometry, const struct geometry_batch *batch) {
    static const struct part whole = {{{{0, 0}}, {{1, 0}}, {{0, 1}}}};
    struct masked masked = {
        .scene = scene, .geometry = geometry, .material = &scene->materials[batch->material]};
    texture_decode_table(masked.decode);
    for (uint32_t i = 0; i < batch->index_count; i += 3) {
        masked.index = &geometry->indices[batch->first_index + i];
        add_part(list, &masked, &whole, depth_of(&masked));
    }
}

static void add_opaque(struct opaque_triangles *list, const struct geometry *geometry,
                       const struct geometry_batch *batch) {
    for (uint32_t i = 0; i < batch->index_count; i += 3) {
        const uint32_t *index = &geometry->indices[batch->first_index + i];
        struct bvh_triangle triangle = {.opaque = {~0U, ~0U},
                                        .number = (batch->first_index + i) / 3};
        triangle.corner = corners_edges(geometry, index, triangle.edges);
        append(list, &triangle);
    }
}

struct opaque_triangles opaque_triangles_of(const struct scene *scene,
                                            const struct geometry *geometry) {
    struct opaque_triangles list = {0};
    for (int b = 0; b < geometry->blocking_batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        if (scene->materials[batch->material].alpha_mask)
            add_masked(&list, scene, geometry, batch);
        else
            add_opaque(&list, geometry, batch);
    }
    return list;
}
