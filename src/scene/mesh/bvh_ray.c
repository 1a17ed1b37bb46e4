#include "scene/mesh/bvh_ray.h"

#include "base/extremes.h"
#include "shared/bvh.h"

#include <math.h>

enum { STACK = 72 }; /* the tree is less deep */

struct ray {
    vec3s origin, direction, inverse;
    bool asks_opacity; /* passes through what is not opaque */
};

/* The distance at which a ray enters a box, INFINITY where it does not before its end. One along a
 * side of the box has 0 / 0 there, which bounds nothing. */
static float entry(const struct bvh_box *box, const struct ray *ray, float end) {
    float from = 0;
    for (int c = 0; c < 3; c++) {
        float a = (box->low[c] - ray->origin.raw[c]) * ray->inverse.raw[c];
        float b = (box->high[c] - ray->origin.raw[c]) * ray->inverse.raw[c];
        from = float_max(float_min(a, b), from);
        end = float_min(float_max(a, b), end);
    }
    return from <= end ? from : INFINITY;
}

static float part_of(float scaled) {
    return float_min(floorf(scaled), OPACITY_SIDE - 1);
}

/* As is_opaque of src/passes/visibility/bvh.glsl [Gruen et al. 2020]. */
static bool is_opaque(const struct bvh_triangle *triangle, float u, float v) {
    float x = u * OPACITY_SIDE, y = v * OPACITY_SIDE, column = part_of(x), row = part_of(y);
    int turned = x - column + y - row > 1;
    int number = (int)row * (2 * OPACITY_SIDE - (int)row) + 2 * (int)column + turned;
    return triangle->opaque[number < 32 ? 0 : 1] >> (number & 31) & 1;
}

/* [Möller and Trumbore 1997] */
static void meet(struct bvh_hit *nearest, const struct bvh_triangle *triangle,
                 const struct ray *ray) {
    vec3s across = glms_vec3_cross(ray->direction, triangle->edges[1]);
    float volume = glms_vec3_dot(triangle->edges[0], across);
    if (volume == 0)
        return;
    float inverse = 1 / volume;
    vec3s to = glms_vec3_sub(ray->origin, triangle->corner);
    vec3s around = glms_vec3_cross(to, triangle->edges[0]);
    float u = glms_vec3_dot(to, across) * inverse;
    float v = glms_vec3_dot(ray->direction, around) * inverse;
    float distance = glms_vec3_dot(triangle->edges[1], around) * inverse;
    if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest->distance &&
        (!ray->asks_opacity || is_opaque(triangle, u, v)))
        *nearest = (struct bvh_hit){triangle, distance, volume > 0};
}

/* A node that the ray enters at so far. */
struct entered {
    uint32_t node;
    float distance;
};

struct pending {
    struct entered nodes[STACK];
    int count;
};

/* The farther child first. */
static void push_children(struct pending *pending, const struct bvh *tree, uint32_t first,
                          const struct ray *ray, float end) {
    const struct bvh_node *child = &tree->nodes[first];
    struct entered nearer = {first, entry(&child[0].box, ray, end)},
                   farther = {first + 1, entry(&child[1].box, ray, end)};
    if (farther.distance < nearer.distance) {
        struct entered swapped = nearer;
        nearer = farther;
        farther = swapped;
    }
    if (farther.distance < INFINITY)
        pending->nodes[pending->count++] = farther;
    if (nearer.distance < INFINITY)
        pending->nodes[pending->count++] = nearer;
}

static struct bvh_hit trace(const struct bvh *tree, const struct ray *ray) {
    struct bvh_hit nearest = {NULL, INFINITY, false};
    struct pending pending;
    pending.nodes[0] = (struct entered){0, 0};
    pending.count = 1;
    for (uint32_t tests = 0; pending.count > 0;) {
        struct entered entered = pending.nodes[--pending.count];
        const struct bvh_node *node = &tree->nodes[entered.node];
        if (entered.distance > nearest.distance)
            continue;
        tests += node->count;
        if (tests > BVH_RAY_TESTS)
            return (struct bvh_hit){NULL, INFINITY, false};
        for (uint32_t i = 0; i < node->count; i++)
            meet(&nearest, &tree->triangles[node->first + i], ray);
        if (node->count == 0)
            push_children(&pending, tree, node->first, ray, nearest.distance);
    }
    return nearest;
}

struct bvh_hit bvh_ray_trace(const struct bvh *tree, vec3s origin, vec3s direction) {
    return trace(
        tree, &(struct ray){origin, direction, glms_vec3_div(glms_vec3_one(), direction), false});
}

struct bvh_hit bvh_ray_trace_opaque(const struct bvh *tree, vec3s origin, vec3s direction) {
    return trace(tree,
                 &(struct ray){origin, direction, glms_vec3_div(glms_vec3_one(), direction), true});
}
