#include "scene/mesh/cut_triangle.h"

#include "base/memory.h"
#include "scene/mesh/corners.h"

#include <math.h>

const struct triangle_part triangle_whole = {{{{0, 0}}, {{1, 0}}, {{0, 1}}}};

static struct corners corners_at(const struct cut_triangle *triangle, vec2s at) {
    const uint32_t *index = triangle->index;
    return (struct corners){{index[0], index[1], index[2]}, {1 - at.x - at.y, at.x, at.y}};
}

vec2s triangle_within(const struct triangle_part *part, float u, float v) {
    vec2s at = glms_vec2_scale(part->at[0], 1 - u - v);
    at = glms_vec2_muladds(part->at[1], u, at);
    return glms_vec2_muladds(part->at[2], v, at);
}

vec4s triangle_color(const struct cut_triangle *triangle, vec2s at) {
    struct corners corners = corners_at(triangle, at);
    return corners_base_color(&corners, triangle->scene, triangle->geometry, triangle->decode,
                              triangle->material);
}

void triangle_quarters(const struct triangle_part *part, struct triangle_part quarters[4]) {
    vec2s middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] = glms_vec2_lerp(part->at[k], part->at[(k + 1) % 3], .5F);
    quarters[0] = (struct triangle_part){{part->at[0], middle[0], middle[2]}};
    quarters[1] = (struct triangle_part){{middle[0], part->at[1], middle[1]}};
    quarters[2] = (struct triangle_part){{middle[2], middle[1], part->at[2]}};
    quarters[3] = (struct triangle_part){{middle[1], middle[2], middle[0]}};
}

int triangle_depth(const struct cut_triangle *triangle, float texels, int most) {
    if (triangle->material->base_color_texture < 0)
        return 0;
    const struct bitmap *bitmap =
        &triangle->scene->textures[triangle->material->base_color_texture].bitmap;
    vec2s uv[3];
    for (int k = 0; k < 3; k++) {
        const float *at = triangle->geometry->uv[0][triangle->index[k]];
        uv[k] = (vec2s){{at[0] * (float)bitmap->width, at[1] * (float)bitmap->height}};
    }
    float all =
        fabsf(glms_vec2_cross(glms_vec2_sub(uv[1], uv[0]), glms_vec2_sub(uv[2], uv[0])) / 2);
    int depth = 0;
    for (; depth < most && texels < all; texels *= 4)
        depth++;
    return depth;
}

static struct bvh_triangle *append(struct triangle_parts *parts) {
    if (parts->count == parts->room) {
        parts->room = parts->room ? 2 * parts->room : 1024;
        parts->items = mem_resize(parts->items, parts->room, sizeof *parts->items);
    }
    return &parts->items[parts->count++];
}

struct bvh_triangle *triangle_parts_add(struct triangle_parts *parts,
                                        const struct cut_triangle *triangle,
                                        const struct triangle_part *part) {
    vec3s places[3];
    for (int k = 0; k < 3; k++) {
        struct corners corners = corners_at(triangle, part->at[k]);
        places[k] = corners_vector(&corners, triangle->geometry->position);
    }
    struct bvh_triangle *added = append(parts);
    *added = (struct bvh_triangle){
        .corner = places[0],
        .edges = {glms_vec3_sub(places[1], places[0]), glms_vec3_sub(places[2], places[0])},
        .number = (uint32_t)(triangle->index - triangle->geometry->indices) / 3,
    };
    return added;
}

struct bvh_triangle *triangle_parts_add_whole(struct triangle_parts *parts,
                                              const struct geometry *geometry,
                                              const uint32_t *index) {
    struct bvh_triangle *added = append(parts);
    *added = (struct bvh_triangle){.number = (uint32_t)(index - geometry->indices) / 3};
    added->corner = corners_edges(geometry, index, added->edges);
    return added;
}
