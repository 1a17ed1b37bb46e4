/* Measures of a surface: whether it closes, which way it faces, how large it is. */
#ifndef TEST_SURFACE_SHAPE_H
#define TEST_SURFACE_SHAPE_H

#include "base/memory.h"
#include "base/unit.h"
#include "scene/shapes/surface.h"

#include <math.h>
#include <stdlib.h>

struct surface_shape {
    double area, volume;
    int wrong_normals;   /* corners of triangles whose vertex normal points to the back */
    double worst_normal; /* least cosine between a vertex normal and a face normal at it */
    int unpaired_edges;  /* directed edges without an opposite one: a border */
    int open_edges;      /* directed edges that do not meet exactly one opposite one */
    int euler;           /* V - E + F */
};

static inline int compare_edges(const void *a, const void *b) {
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Edges as (from, to) and (to, from), sorted, so that a closed surface has two equal lists. */
static inline void count_edges(const struct surface *surface, struct surface_shape *shape) {
    uint32_t count = surface->index_count;
    uint64_t *forth = mem_alloc(count, sizeof *forth), *back = mem_alloc(count, sizeof *back);
    for (uint32_t i = 0; i < count; i++) {
        uint64_t a = surface->indices[i], b = surface->indices[i % 3 == 2 ? i - 2 : i + 1];
        forth[i] = a << 32 | b;
        back[i] = b << 32 | a;
    }
    qsort(forth, count, sizeof *forth, compare_edges);
    qsort(back, count, sizeof *back, compare_edges);
    for (uint32_t i = 0; i < count; i++) {
        shape->unpaired_edges += forth[i] != back[i];
        shape->open_edges += forth[i] != back[i] || (i > 0 && forth[i] == forth[i - 1]);
    }
    free(forth);
    free(back);
}

static inline struct surface_shape measure_surface(const struct surface *surface) {
    struct surface_shape shape = {.worst_normal = 1.0};
    count_edges(surface, &shape);
    for (uint32_t i = 0; i < surface->index_count; i += 3) {
        const uint32_t *v = surface->indices + i;
        float *a = surface->position[v[0]];
        vec3 ab, ac, cross;
        glm_vec3_sub(surface->position[v[1]], a, ab);
        glm_vec3_sub(surface->position[v[2]], a, ac);
        glm_vec3_cross(ab, ac, cross);
        shape.area += 0.5 * glm_vec3_norm(cross);
        shape.volume += glm_vec3_dot(a, cross) / 6.0;
        vec3_unit(cross);
        for (int k = 0; k < 3; k++) {
            double cosine = glm_vec3_dot(cross, surface->normal[v[k]]);
            shape.worst_normal = fmin(shape.worst_normal, cosine);
            shape.wrong_normals += cosine <= 0.0;
        }
    }
    /* In a closed surface each edge belongs to two triangles. */
    shape.euler =
        (int)surface->vertex_count - (int)surface->index_count / 2 + (int)surface->index_count / 3;
    return shape;
}

#endif
