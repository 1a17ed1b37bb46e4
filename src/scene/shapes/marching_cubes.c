#include "scene/shapes/marching_cubes.h"

#include "base/memory.h"
#include "base/unit.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2). An edge goes from a corner in + direction
 * of an axis and is called 3 corner + axis. */
enum { CORNERS = 8, EDGES = 3 * CORNERS, NO_EDGE = 0xFF, CASE_END = 0xFF };

/* --- the table of cases ----------------------------------------------------------------------- */

static int edge_between(int a, int b) {
    int low = a < b ? a : b, axis = (a ^ b) >> 1;
    return 3 * low + axis;
}

/* The four corners of a face, counter-clockwise seen from outside. */
static void face_corners(int axis, int side, int corners[4]) {
    int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
    int counter_clockwise[4] = {base, base | u, base | u | v, base | v};
    for (int i = 0; i < 4; i++)
        corners[i] = counter_clockwise[side ? i : 3 - i];
}

/* Walking round a face, each run of inside corners is cut off by one segment from the edge where
 * the walk enters to the edge where it leaves. Seen from outside the surface, these segments run
 * counter-clockwise round it. */
static void cut_face(int inside, int axis, int side, uint8_t next[EDGES]) {
    int corners[4];
    face_corners(axis, side, corners);
    for (int i = 0; i < 4; i++) {
        int before = corners[(i + 3) % 4], end = i;
        if (inside >> before & 1 || !(inside >> corners[i] & 1))
            continue;
        while (inside >> corners[(end + 1) % 4] & 1)
            end++;
        next[edge_between(before, corners[i])] =
            (uint8_t)edge_between(corners[end % 4], corners[(end + 1) % 4]);
    }
}

/* Whether a line between two edges lies in a face of the cell. */
static bool share_face(int edge, int other) {
    for (int axis = 0; axis < 3; axis++) {
        bool across = edge % 3 == axis || other % 3 == axis;
        if (!across && ((edge / 3) >> axis & 1) == ((other / 3) >> axis & 1))
            return true;
    }
    return false;
}

/* The loop's vertex from which a fan has no diagonal in a face: the neighbour might have the same,
 * and four triangles would meet in one line. */
static int fan_apex(const uint8_t *loop, int length) {
    for (int apex = 0; apex < length; apex++) {
        bool clean = true;
        for (int i = 2; i < length - 1; i++)
            clean = clean && !share_face(loop[apex], loop[(apex + i) % length]);
        if (clean)
            return apex;
    }
    assert(!"every loop has a clean fan");
    return 0;
}

static int add_fan(uint8_t *triangles, int used, const uint8_t *loop, int length) {
    int apex = fan_apex(loop, length);
    for (int i = 1; i < length - 1; i++) {
        triangles[used++] = loop[apex];
        triangles[used++] = loop[(apex + i) % length];
        triangles[used++] = loop[(apex + i + 1) % length];
    }
    assert(used < MARCHING_CASE_SIZE);
    return used;
}

static void make_case(int inside, uint8_t triangles[MARCHING_CASE_SIZE]) {
    uint8_t next[EDGES];
    memset(next, NO_EDGE, sizeof next);
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++)
            cut_face(inside, axis, side, next);
    int used = 0;
    for (int first = 0; first < EDGES; first++) {
        uint8_t loop[EDGES];
        int length = 0;
        for (int edge = first; next[edge] != NO_EDGE;) {
            loop[length++] = (uint8_t)edge;
            int following = next[edge];
            next[edge] = NO_EDGE;
            edge = following;
        }
        if (length > 0)
            used = add_fan(triangles, used, loop, length);
    }
    triangles[used] = CASE_END;
}

void marching_cubes_init(struct marching_cubes *cubes) {
    *cubes = (struct marching_cubes){0};
    for (int inside = 0; inside < MARCHING_CASES; inside++)
        make_case(inside, cubes->cases[inside]);
}

void marching_cubes_free(struct marching_cubes *cubes) {
    for (int i = 0; i < 2; i++) {
        mem_free(cubes->values[i], cubes->vertices[i]);
    }
    free(cubes->wrong);
    *cubes = (struct marching_cubes){0};
}

/* --- the sweep -------------------------------------------------------------------------------- */

/* What one call works on. Slice k's memory is number k % 2. */
struct sweep {
    struct marching_cubes *cubes;
    const struct implicit *implicit;
    const struct marching_grid *grid;
    struct surface *surface;
    int width, height; /* of a slice, in points */
};

static void sample_slice(const struct sweep *sweep, int k) {
    const struct marching_grid *grid = sweep->grid;
    for (int j = 0; j < sweep->height; j++) {
        vec3 first = {grid->low[0], grid->low[1] + (float)j * grid->step,
                      grid->low[2] + (float)k * grid->step};
        sweep->implicit->row(sweep->implicit->context, first, grid->step, sweep->width,
                             sweep->cubes->values[k % 2] + j * sweep->width);
    }
}

/* The vertex where the edge from a grid point along an axis meets the surface. */
static uint32_t add_vertex(const struct sweep *sweep, const int at[3], int axis, float value,
                           float next_value) {
    const struct marching_grid *grid = sweep->grid;
    /* Not quite into the corner, where the vertices of several edges would fall together. */
    float t = glm_clamp(value / (value - next_value), 0.01f, 0.99f);
    vec3 position, normal;
    for (int i = 0; i < 3; i++)
        position[i] = grid->low[i] + ((float)at[i] + (i == axis ? t : 0.0f)) * grid->step;
    sweep->implicit->gradient(sweep->implicit->context, position, normal);
    glm_vec3_negate(normal);
    vec3_unit(normal);
    return surface_add_vertex(sweep->surface, position, normal);
}

/* The vertices on the edges within slice k, and on those that come to it from the slice before. */
static void add_slice_vertices(const struct sweep *sweep, int k) {
    const float *values = sweep->cubes->values[k % 2], *before = sweep->cubes->values[(k + 1) % 2];
    uint32_t(*vertices)[3] = sweep->cubes->vertices[k % 2];
    uint32_t(*vertices_before)[3] = sweep->cubes->vertices[(k + 1) % 2];
    for (int j = 0; j < sweep->height; j++)
        for (int i = 0; i < sweep->width; i++) {
            int n = j * sweep->width + i, row = sweep->width;
            bool inside = values[n] > 0.0f;
            if (i + 1 < sweep->width && inside != (values[n + 1] > 0.0f))
                vertices[n][0] = add_vertex(sweep, (int[]){i, j, k}, 0, values[n], values[n + 1]);
            if (j + 1 < sweep->height && inside != (values[n + row] > 0.0f))
                vertices[n][1] = add_vertex(sweep, (int[]){i, j, k}, 1, values[n], values[n + row]);
            if (k > 0 && inside != (before[n] > 0.0f))
                vertices_before[n][2] =
                    add_vertex(sweep, (int[]){i, j, k - 1}, 2, before[n], values[n]);
        }
}

/* The triangles of the cells between slice k - 1 and slice k. */
static void add_slab_triangles(const struct sweep *sweep, int k) {
    const struct marching_cubes *cubes = sweep->cubes;
    const float *low = cubes->values[(k + 1) % 2], *high = cubes->values[k % 2];
    uint32_t(*const vertices[2])[3] = {cubes->vertices[(k + 1) % 2], cubes->vertices[k % 2]};
    for (int j = 0; j + 1 < sweep->height; j++)
        for (int i = 0; i + 1 < sweep->width; i++) {
            int n = j * sweep->width + i;
            const int points[4] = {n, n + 1, n + sweep->width, n + sweep->width + 1};
            int inside = 0;
            for (int c = 0; c < 4; c++)
                inside |= (low[points[c]] > 0.0f) << c | (high[points[c]] > 0.0f) << (c + 4);
            for (const uint8_t *edge = cubes->cases[inside]; *edge != CASE_END; edge += 3) {
                uint32_t triangle[3];
                for (int v = 0; v < 3; v++) {
                    int corner = edge[v] / 3;
                    triangle[v] = vertices[corner / 4][points[corner % 4]][edge[v] % 3];
                }
                surface_add_triangle(sweep->surface, triangle[0], triangle[1], triangle[2]);
            }
        }
}

/* --- normals ---------------------------------------------------------------------------------- */

static void face_normal(const struct surface *surface, const uint32_t *triangle, vec3 normal) {
    vec3 ab, ac;
    glm_vec3_sub(surface->position[triangle[1]], surface->position[triangle[0]], ab);
    glm_vec3_sub(surface->position[triangle[2]], surface->position[triangle[0]], ac);
    glm_vec3_cross(ab, ac, normal);
}

/* Where the surface is finer than the grid, as at the neck of two balls about to part, the gradient
 * can point to the back of a triangle. Such vertices get the mean normal of their triangles. */
static void mend_normals(struct marching_cubes *cubes, struct surface *surface,
                         uint32_t first_vertex, uint32_t first_index) {
    uint32_t count = surface->vertex_count - first_vertex;
    if (count == 0)
        return;
    if (count > cubes->wrong_capacity) {
        cubes->wrong_capacity = surface->vertex_capacity;
        cubes->wrong = mem_resize(cubes->wrong, cubes->wrong_capacity, sizeof *cubes->wrong);
    }
    memset(cubes->wrong, 0, count);
    bool *wrong = cubes->wrong;
    vec3 normal;
    for (uint32_t i = first_index; i < surface->index_count; i += 3) {
        face_normal(surface, surface->indices + i, normal);
        for (uint32_t k = i; k < i + 3; k++)
            if (glm_vec3_dot(normal, surface->normal[surface->indices[k]]) < 0.0f)
                wrong[surface->indices[k] - first_vertex] = true;
    }
    for (uint32_t i = 0; i < count; i++)
        if (wrong[i])
            glm_vec3_zero(surface->normal[first_vertex + i]);
    for (uint32_t i = first_index; i < surface->index_count; i++)
        if (wrong[surface->indices[i] - first_vertex]) {
            face_normal(surface, surface->indices + i - (i - first_index) % 3, normal);
            vec3_unit(normal);
            glm_vec3_add(surface->normal[surface->indices[i]], normal,
                         surface->normal[surface->indices[i]]);
        }
    for (uint32_t i = 0; i < count; i++)
        if (wrong[i])
            vec3_unit(surface->normal[first_vertex + i]);
}

void marching_cubes_polygonise(struct marching_cubes *cubes, const struct implicit *implicit,
                               const struct marching_grid *grid, struct surface *surface) {
    struct sweep sweep = {cubes, implicit, grid, surface, grid->cells[0] + 1, grid->cells[1] + 1};
    uint32_t first_vertex = surface->vertex_count, first_index = surface->index_count;
    size_t points = (size_t)sweep.width * (size_t)sweep.height;
    for (int i = 0; i < 2 && points > cubes->capacity; i++) {
        cubes->values[i] = mem_resize(cubes->values[i], points, sizeof **cubes->values);
        cubes->vertices[i] = mem_resize(cubes->vertices[i], points, sizeof **cubes->vertices);
    }
    if (points > cubes->capacity)
        cubes->capacity = points;
    for (int k = 0; k <= grid->cells[2]; k++) {
        sample_slice(&sweep, k);
        add_slice_vertices(&sweep, k);
        if (k > 0)
            add_slab_triangles(&sweep, k);
    }
    mend_normals(cubes, surface, first_vertex, first_index);
}
