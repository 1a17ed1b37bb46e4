#include "atrium/masonry.h"
#include "base/unit.h"
#include "shapes/shapes.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

enum { POINTS_MAX = 65 };

/* cos and sin of i of n steps through half a circle, symmetric to the bit. */
static void half_circle(int i, int n, float *cosine, float *sine) {
    int near = i <= n / 2 ? i : n - i;
    double angle = GLM_PI * near / n;
    *cosine = near == n / 2 ? 0.0f : (float)(i <= n / 2 ? cos(angle) : -cos(angle));
    *sine = (float)sin(angle);
}

/* --- arches ----------------------------------------------------------------------------------- */

/* The opening's edge from the right foot over the crown to the left foot, and for each point one of
 * the wall's outline, so that strips between them fill the wall. */
struct arch_outline {
    int count;
    float edge[POINTS_MAX][2], normal[POINTS_MAX][2], outer[POINTS_MAX][2];
};

static void add_outline_point(struct arch_outline *outline, const float edge[2],
                              const float normal[2], const float outer[2]) {
    int i = outline->count++;
    assert(i < POINTS_MAX);
    for (int k = 0; k < 2; k++) {
        outline->edge[i][k] = edge[k];
        outline->normal[i][k] = normal[k];
        outline->outer[i][k] = outer[k];
    }
}

/* The first quarter of the arch belongs to the right side of the wall, half of it to the top. */
static void outer_point(const struct arch_wall *wall, int i, float outer[2]) {
    float t = (float)i / (float)wall->segments, half = 0.5f * wall->width;
    float up = fminf(4.0f * fminf(t, 1.0f - t), 1.0f);
    outer[0] = half * fmaxf(fminf(2.0f - 4.0f * t, 1.0f), -1.0f);
    outer[1] = wall->spring + (wall->high - wall->spring) * up;
}

static struct arch_outline arch_outline(const struct arch_wall *wall) {
    struct arch_outline outline = {0};
    const float right[2] = {wall->half_opening, wall->low}, left[2] = {-right[0], wall->low};
    const float half = 0.5f * wall->width;
    bool has_legs = wall->low < wall->spring;
    if (has_legs)
        add_outline_point(&outline, right, (const float[]){-1.0f, 0.0f},
                          (const float[]){half, wall->low});
    for (int i = 0; i <= wall->segments; i++) {
        float c, s, outer[2];
        half_circle(i, wall->segments, &c, &s);
        float normal[2] = {-c / wall->half_opening, -s / wall->rise};
        float length = hypotf(normal[0], normal[1]);
        outer_point(wall, i, outer);
        add_outline_point(&outline,
                          (const float[]){wall->half_opening * c, wall->spring + wall->rise * s},
                          (const float[]){normal[0] / length, normal[1] / length}, outer);
    }
    if (has_legs)
        add_outline_point(&outline, left, (const float[]){1.0f, 0.0f},
                          (const float[]){-half, wall->low});
    return outline;
}

/* A strip along the outline between two depths, from the points at `from` to those at `to`. */
static void add_flat(struct surface *surface, const float from[2], const float from_next[2],
                     const float to[2], const float to_next[2], float from_z, float to_z) {
    add_quad(surface, (const float[]){from[0], from[1], from_z},
             (const float[]){to[0], to[1], to_z}, (const float[]){to_next[0], to_next[1], to_z},
             (const float[]){from_next[0], from_next[1], from_z});
}

static void add_intrados(struct surface *surface, const struct arch_outline *outline, float z) {
    uint32_t first = surface->vertex_count;
    for (int i = 0; i < outline->count; i++)
        for (int side = -1; side <= 1; side += 2)
            surface_add_vertex(
                surface, (const float[]){outline->edge[i][0], outline->edge[i][1], (float)side * z},
                (const float[]){outline->normal[i][0], outline->normal[i][1], 0.0f});
    for (uint32_t i = 0; i + 1 < (uint32_t)outline->count; i++) {
        uint32_t back = first + 2 * i, front = back + 1;
        surface_add_triangle(surface, back, front, front + 2);
        surface_add_triangle(surface, back, front + 2, back + 2);
    }
}

void add_arch_wall(struct surface *surface, const struct arch_wall *wall) {
    struct arch_outline outline = arch_outline(wall);
    const float z = 0.5f * wall->thickness;
    float(*edge)[2] = outline.edge, (*outer)[2] = outline.outer;
    for (int i = 0; i + 1 < outline.count; i++) {
        add_flat(surface, edge[i], edge[i + 1], outer[i], outer[i + 1], z, z);
        add_flat(surface, outer[i], outer[i + 1], edge[i], edge[i + 1], -z, -z);
        add_flat(surface, outer[i], outer[i + 1], outer[i], outer[i + 1], z, -z);
    }
    int last = outline.count - 1;
    add_flat(surface, edge[0], outer[0], edge[0], outer[0], z, -z);
    add_flat(surface, outer[last], edge[last], outer[last], edge[last], z, -z);
    add_intrados(surface, &outline, z);
}

/* The profile's point k carried to outline point i: away from the opening and forward. */
static void carry(const struct arch_outline *outline, int i, const float profile[2],
                  float point[3]) {
    point[0] = outline->edge[i][0] - outline->normal[i][0] * profile[0];
    point[1] = outline->edge[i][1] - outline->normal[i][1] * profile[0];
    point[2] = profile[1];
}

void add_archivolt(struct surface *surface, const struct arch_wall *wall, const float (*profile)[2],
                   int count) {
    struct arch_outline outline = arch_outline(wall);
    for (int k = 0; k < count; k++)
        for (int i = 0; i + 1 < outline.count; i++) {
            float a[3], b[3], c[3], d[3];
            carry(&outline, i, profile[k], a);
            carry(&outline, i, profile[(k + 1) % count], b);
            carry(&outline, i + 1, profile[(k + 1) % count], c);
            carry(&outline, i + 1, profile[k], d);
            add_quad(surface, a, d, c, b);
        }
    for (int end = 0; end < 2; end++) {
        uint32_t first = surface->vertex_count;
        for (int k = 0; k < count; k++) {
            float point[3];
            carry(&outline, end ? outline.count - 1 : 0, profile[k], point);
            surface_add_vertex(surface, point, (const float[]){0.0f, -1.0f, 0.0f});
        }
        for (uint32_t k = 1; k + 1 < (uint32_t)count; k++)
            surface_add_triangle(surface, first, first + k + end, first + k + !end);
    }
}

/* --- vaults ----------------------------------------------------------------------------------- */

/* One of the four parts of a vault: over the part of the block beyond both diagonals on one side.
 * There the vault is a barrel that runs straight out to that side. */
struct vault_side {
    const struct groin_vault *vault;
    int axis, sign; /* the side: axis 0 = x, 2 = z */
};

/* Point i of the curve: on the diagonal (out = 0), on the block's side (1) or above it (2). */
static void vault_point(const struct vault_side *side, int i, int out, float point[3]) {
    const struct groin_vault *vault = side->vault;
    float c, s, half[3] = {vault->half_x, 0.0f, vault->half_z};
    half_circle(i, vault->segments, &c, &s);
    point[side->axis] = (float)side->sign * half[side->axis] * (out > 0 ? 1.0f : fabsf(c));
    point[2 - side->axis] = -(float)side->sign * c * half[2 - side->axis];
    point[1] = out > 1 ? vault->height : vault->rise * s;
}

static uint32_t add_barrel_vertex(struct surface *surface, const struct vault_side *side, int i,
                                  int out) {
    const struct groin_vault *vault = side->vault;
    float across = side->axis == 0 ? vault->half_z : vault->half_x;
    float point[3];
    vec3 normal = {0.0f, 0.0f, 0.0f};
    vault_point(side, i, out, point);
    normal[1] = -point[1] / (vault->rise * vault->rise);
    normal[2 - side->axis] = -point[2 - side->axis] / (across * across);
    vec3_unit(normal);
    return surface_add_vertex(surface, point, normal);
}

/* x and z swap with the axis, which mirrors the part: the winding follows. */
static void add_turned(struct surface *surface, const struct vault_side *side, uint32_t a,
                       uint32_t b, uint32_t c) {
    if (side->axis == 0)
        surface_add_triangle(surface, a, b, c);
    else
        surface_add_triangle(surface, a, c, b);
}

static void add_barrel(struct surface *surface, const struct vault_side *side) {
    int n = side->vault->segments;
    uint32_t first = surface->vertex_count;
    for (int i = 0; i <= n; i++)
        for (int out = 0; out < 2; out++)
            add_barrel_vertex(surface, side, i, out);
    for (int i = 0; i < n; i++) {
        uint32_t inner = first + 2 * (uint32_t)i, outer = inner + 1;
        /* At its ends the strip tapers to the corner of the block. */
        if (i > 0)
            add_turned(surface, side, inner, outer, outer + 2);
        if (i + 1 < n)
            add_turned(surface, side, inner, outer + 2, inner + 2);
    }
}

static void add_block_side(struct surface *surface, const struct vault_side *side) {
    const float center[3] = {0.0f, side->vault->height, 0.0f};
    const float up[3] = {0.0f, 1.0f, 0.0f};
    float out[3] = {0.0f, 0.0f, 0.0f};
    out[side->axis] = (float)side->sign;
    for (int i = 0; i < side->vault->segments; i++) {
        float corners[4][3];
        vault_point(side, i, 1, corners[0]);
        vault_point(side, i, 2, corners[1]);
        vault_point(side, i + 1, 2, corners[2]);
        vault_point(side, i + 1, 1, corners[3]);
        uint32_t first = surface->vertex_count;
        for (int k = 0; k < 4; k++)
            surface_add_vertex(surface, corners[k], out);
        add_turned(surface, side, first, first + 1, first + 2);
        add_turned(surface, side, first, first + 2, first + 3);
        surface_add_vertex(surface, corners[1], up);
        surface_add_vertex(surface, center, up);
        surface_add_vertex(surface, corners[2], up);
        add_turned(surface, side, first + 4, first + 5, first + 6);
    }
}

void add_groin_vault(struct surface *surface, const struct groin_vault *vault) {
    for (int axis = 0; axis <= 2; axis += 2)
        for (int sign = -1; sign <= 1; sign += 2) {
            struct vault_side side = {vault, axis, sign};
            add_barrel(surface, &side);
            add_block_side(surface, &side);
        }
}
