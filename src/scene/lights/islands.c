#include "scene/lights/islands.h"

#include "base/memory.h"
#include "scene/lights/faces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Places are rounded to so much of the largest coordinate: some 30 times the rounding of a float */
static const float nearness = 2e-6F;

/* --- corners that touch ----------------------------------------------------------------------- */

struct corner {
    int32_t at[3];
    uint32_t vertex;
};

static int by_place(const void *a, const void *b) {
    return memcmp(a, b, sizeof((struct corner *)0)->at);
}

static uint32_t root_of(uint32_t *parents, uint32_t vertex) {
    while (parents[vertex] != vertex)
        vertex = parents[vertex] = parents[parents[vertex]];
    return vertex;
}

static void join(uint32_t *parents, uint32_t a, uint32_t b) {
    parents[root_of(parents, a)] = root_of(parents, b);
}

static void join_places(uint32_t *parents, const struct primitive *primitive) {
    size_t count = (size_t)primitive->vertex_count;
    struct corner *corners = mem_alloc(count, sizeof *corners);
    float largest = 1e-30F;
    for (size_t i = 0; i < 3 * count; i++)
        largest = fmaxf(largest, fabsf(primitive->position[i / 3][i % 3]));
    for (size_t i = 0; i < 3 * count; i++) {
        corners[i / 3].vertex = (uint32_t)i / 3;
        corners[i / 3].at[i % 3] =
            (int32_t)roundf(primitive->position[i / 3][i % 3] / (nearness * largest));
    }
    qsort(corners, count, sizeof *corners, by_place);
    for (size_t i = 1; i < count; i++)
        if (by_place(&corners[i - 1], &corners[i]) == 0)
            join(parents, corners[i - 1].vertex, corners[i].vertex);
    free(corners);
}

/* True for triangles without area, which strips have from one part to the next. */
static bool has_twins(const struct primitive *primitive, const uint32_t triangle[3]) {
    for (int k = 0; k < 3; k++)
        if (memcmp(primitive->position[triangle[k]], primitive->position[triangle[(k + 1) % 3]],
                   sizeof primitive->position[0]) == 0)
            return true;
    return false;
}

/* --- triangles -------------------------------------------------------------------------------- */

/* Numbers the islands, from 1 on, in the order of their triangles, and counts what each has: in
 * ends. Triangles without area join nothing and are an island of their own. */
static void number(struct islands *islands, const struct primitive *primitive, int *number_of) {
    uint32_t *parents = mem_alloc((size_t)primitive->vertex_count, sizeof *parents);
    int *of_roots = mem_alloc((size_t)primitive->vertex_count, sizeof *of_roots), without_area = 0;
    for (int v = 0; v < primitive->vertex_count; v++)
        parents[v] = (uint32_t)v;
    join_places(parents, primitive);
    for (int i = 0; i < primitive->index_count; i++)
        if (!has_twins(primitive, &primitive->indices[i - i % 3]))
            join(parents, primitive->indices[i - i % 3], primitive->indices[i]);
    for (int i = 0; i < primitive->index_count; i += 3) {
        int *of_root = has_twins(primitive, &primitive->indices[i])
                           ? &without_area
                           : &of_roots[root_of(parents, primitive->indices[i])];
        *of_root = *of_root ? *of_root : ++islands->count;
        number_of[i / 3] = *of_root;
        islands->ends[*of_root] += 3;
    }
    mem_free(parents, of_roots);
}

/* ends: of islands from 1 on; each moves from the begin of its island to the end. */
static void sort(const struct islands *islands, struct primitive *primitive, const int *number_of) {
    uint32_t *from = primitive->indices;
    uint32_t *to = mem_alloc((size_t)primitive->index_count, sizeof *to);
    int begin = 0;
    for (int n = 1; n <= islands->count; n++) {
        int count = islands->ends[n];
        islands->ends[n] = begin;
        begin += count;
    }
    for (int i = 0; i < primitive->index_count; i += 3) {
        int *end = &islands->ends[number_of[i / 3]];
        memcpy(&to[*end], &from[i], 3 * sizeof *to);
        *end += 3;
    }
    primitive->indices = to;
    free(from);
}

/* Makes an island of each face of a solid. */
static void split(struct islands *islands, struct primitive *primitive) {
    int *ends = mem_alloc((size_t)primitive->index_count / 3 + 1, sizeof *ends), count = 0;
    for (int i = 0; i < islands->count; i++) {
        int of_faces[FACES_MAX];
        struct primitive island = *primitive;
        island.indices += islands->ends[i];
        island.index_count = islands->ends[i + 1] - islands->ends[i];
        int faces = faces_sort(&island, of_faces);
        for (int k = 0; k < faces; k++)
            ends[++count] = islands->ends[i] + of_faces[k];
    }
    free(islands->ends);
    *islands = (struct islands){ends, count};
}

void islands_init(struct islands *islands, struct primitive *primitive) {
    size_t triangles = (size_t)primitive->index_count / 3;
    int *number_of = mem_alloc(triangles, sizeof *number_of);
    *islands = (struct islands){mem_alloc(triangles + 1, sizeof *islands->ends), 0};
    number(islands, primitive, number_of);
    sort(islands, primitive, number_of);
    split(islands, primitive);
    free(number_of);
}
