#include "scene/mesh/caster.h"

#include "base/memory.h"
#include "scene/mesh/edge_table.h"
#include "scene/mesh/simplify.h"

#include <assert.h>
#include <cglm/cglm.h>
#include <stdlib.h>
#include <string.h>

/* What grows while triangles are split. */
struct splitter {
    struct caster *caster;
    const struct geometry *geometry;
    const uint32_t *moved_to;    /* the vertex that stands for each; NULL = itself */
    struct edge_table midpoints; /* vertex number of each split edge's; 0 = not made yet */
    float (*extra)[3];           /* positions of the extra vertices */
    uint32_t index_capacity, extra_capacity;
    float max_edge_squared;
};

static const float *position_of(const struct splitter *splitter, uint32_t vertex) {
    uint32_t base = splitter->caster->base_count;
    return vertex < base ? splitter->geometry->position[vertex] : splitter->extra[vertex - base];
}

/* This and the length below give the same bits for a, b as for b, a: that keeps cracks shut. */
static void midpoint(const float *a, const float *b, int width, float *out) {
    for (int c = 0; c < width; c++)
        out[c] = .5F * a[c] + .5F * b[c];
}

static float length_squared(const struct splitter *splitter, uint32_t from, uint32_t to) {
    const float *a = position_of(splitter, from), *b = position_of(splitter, to);
    float sum = 0;
    for (int c = 0; c < 3; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

static uint32_t add_midpoint(struct splitter *splitter, uint32_t a, uint32_t b) {
    struct caster *caster = splitter->caster;
    if (caster->extra_count == splitter->extra_capacity) {
        uint32_t capacity = splitter->extra_capacity = 2 * splitter->extra_capacity + 1024;
        splitter->extra = mem_resize(splitter->extra, capacity, sizeof *splitter->extra);
        caster->midpoint_of =
            mem_resize(caster->midpoint_of, capacity, sizeof *caster->midpoint_of);
    }
    uint32_t i = caster->extra_count++;
    midpoint(position_of(splitter, a), position_of(splitter, b), 3, splitter->extra[i]);
    caster->midpoint_of[i][0] = a;
    caster->midpoint_of[i][1] = b;
    return caster->base_count + i;
}

static uint32_t midpoint_between(struct splitter *splitter, uint32_t a, uint32_t b) {
    uint32_t *vertex = edge_table_at(&splitter->midpoints, a, b);
    if (*vertex == 0)
        *vertex = add_midpoint(splitter, a, b);
    return *vertex;
}

static void emit(struct splitter *splitter, const uint32_t corner[3]) {
    struct caster *caster = splitter->caster;
    if (caster->index_count + 3 > splitter->index_capacity) {
        splitter->index_capacity += splitter->index_capacity / 2 + 3 * 1024;
        caster->indices =
            mem_resize(caster->indices, splitter->index_capacity, sizeof *caster->indices);
    }
    memcpy(caster->indices + caster->index_count, corner, 3 * sizeof *corner);
    caster->index_count += 3;
}

/* Bisects the longest edge while it is too long, which keeps angles from getting ever smaller
 * [Rosenberg and Stenger 1975]. Any other long edge stays whole in one of the halves and is
 * bisected there: in the end it is cut at the same points whichever triangle looks at it. False
 * when there would be more indices than the limit. */
static bool split(struct splitter *splitter, const uint32_t corner[3], uint32_t max_indices) {
    if (splitter->caster->index_count >= max_indices)
        return false;
    int longest = 0;
    float length[3];
    for (int e = 0; e < 3; e++) {
        length[e] = length_squared(splitter, corner[e], corner[(e + 1) % 3]);
        if (length[e] > length[longest])
            longest = e;
    }
    if (length[longest] <= splitter->max_edge_squared) {
        emit(splitter, corner);
        return true;
    }
    uint32_t a = corner[longest], b = corner[(longest + 1) % 3], c = corner[(longest + 2) % 3];
    uint32_t middle = midpoint_between(splitter, a, b);
    return split(splitter, (uint32_t[]){a, middle, c}, max_indices) &&
           split(splitter, (uint32_t[]){middle, b, c}, max_indices);
}

/* False where moving has left nothing of the triangle. */
static bool move_corners(const struct splitter *splitter, const uint32_t corner[3],
                         uint32_t moved[3]) {
    for (int c = 0; c < 3; c++)
        moved[c] = splitter->moved_to ? splitter->moved_to[corner[c]] : corner[c];
    return !splitter->moved_to ||
           (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]);
}

static bool split_batch(struct splitter *splitter, const struct geometry_batch *batch) {
    struct caster *caster = splitter->caster;
    struct geometry_batch *made = &caster->batches[caster->batch_count++];
    *made = *batch;
    made->first_index = caster->index_count;
    for (uint32_t k = 0; k < batch->index_count; k += 3) {
        uint32_t at = batch->first_index + k;
        const uint32_t *corner = &splitter->geometry->indices[at];
        uint32_t moved[3];
        if (batch->dynamic)
            emit(splitter, corner);
        else if (move_corners(splitter, corner, moved) &&
                 !split(splitter, moved, at + 3 + 3 * CASTER_MAX_EXTRA_TRIANGLES))
            return false;
    }
    made->index_count = caster->index_count - made->first_index;
    return true;
}

/* Splits everything by the bound; false when there would be too many triangles. */
static bool try_bound(struct caster *caster, const struct geometry *geometry,
                      const uint32_t *moved_to, float max_edge) {
    *caster = (struct caster){.max_edge = max_edge, .base_count = geometry->vertex_count};
    caster->batches = mem_alloc((size_t)geometry->batch_count, sizeof *caster->batches);
    struct splitter splitter = {
        .caster = caster,
        .geometry = geometry,
        .moved_to = moved_to,
        .max_edge_squared = max_edge * max_edge,
    };
    bool good = true;
    for (int i = 0; good && i < geometry->batch_count; i++) {
        good = split_batch(&splitter, &geometry->batches[i]);
        if (geometry->batches[i].first_index < geometry->opaque_index_count)
            caster->opaque_index_count = caster->index_count;
    }
    free(splitter.extra);
    edge_table_free(&splitter.midpoints);
    return good;
}

/* No triangle with edges up to the bound is larger than the equilateral one. A bound that this
 * rules out need not be tried. */
static float least_bound(const struct geometry *geometry) {
    double area = 0;
    for (uint32_t k = 0; k < geometry->index_count; k += 3) {
        const uint32_t *corner = &geometry->indices[k];
        vec3 edge[2], normal;
        for (int e = 0; e < 2; e++)
            glm_vec3_sub(geometry->position[corner[e + 1]], geometry->position[corner[0]], edge[e]);
        glm_vec3_cross(edge[0], edge[1], normal);
        area += .5 * (double)glm_vec3_norm(normal);
    }
    double most = geometry->index_count / 3 + CASTER_MAX_EXTRA_TRIANGLES;
    return (float)sqrt(area / (sqrt(3) / 4 * most));
}

/* The part that has the vertex: the last that begins before or at it. */
static int part_of(const struct geometry *geometry, uint32_t vertex) {
    int low = 0, high = geometry->part_count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        *(geometry->parts[middle].first_vertex <= vertex ? &low : &high) = middle;
    }
    return low;
}

/* The triangles of a part follow one another, and so do its extra vertices. */
static void find_parts(struct caster *caster, const struct geometry *geometry) {
    caster->parts = mem_alloc((size_t)geometry->part_count, sizeof *caster->parts);
    for (uint32_t i = 0; geometry->part_count && i < caster->extra_count; i++) {
        uint32_t vertex = caster->base_count + i;
        while (vertex >= caster->base_count)
            vertex = caster->midpoint_of[vertex - caster->base_count][0];
        struct caster_part *part = &caster->parts[part_of(geometry, vertex)];
        if (part->extra_count++ == 0)
            part->first_extra = i;
        assert(part->first_extra + part->extra_count == i + 1);
    }
}

void caster_init(struct caster *caster, const struct geometry *geometry,
                 const struct caster_desc *desc) {
    float max_edge = desc->max_edge * geometry->radius, error = desc->error * geometry->radius;
    assert(max_edge > 0);
    /* An edge only a few steps of a float long has no midpoint of its own. */
    for (int c = 0; c < 3; c++)
        max_edge = fmaxf(max_edge, 1e-6F * fmaxf(fabsf(geometry->bounds_min[c]),
                                                 fabsf(geometry->bounds_max[c])));
    float least = least_bound(geometry);
    while (max_edge < least)
        max_edge *= 2;
    uint32_t *moved_to =
        error > 0 ? simplify_geometry(geometry,
                                      &(struct simplify_desc){.error = error, .max_edge = max_edge})
                  : NULL;
    while (!try_bound(caster, geometry, moved_to, max_edge)) {
        caster_free(caster);
        max_edge *= 2;
    }
    find_parts(caster, geometry);
    free(moved_to);
}

void caster_free(struct caster *caster) {
    free(caster->parts);
    free(caster->midpoint_of);
    free(caster->indices);
    free(caster->batches);
    *caster = (struct caster){0};
}

/* Fills some of an array of the extra vertices from one of the geometry's. */
static void fill(const struct caster *caster, struct caster_part range, const float *base,
                 int width, float *extra) {
    for (size_t i = range.first_extra; i < range.first_extra + range.extra_count; i++) {
        const float *end[2];
        for (int e = 0; e < 2; e++) {
            uint32_t vertex = caster->midpoint_of[i][e];
            end[e] = vertex < caster->base_count
                         ? base + (size_t)vertex * (size_t)width
                         : extra + (size_t)(vertex - caster->base_count) * (size_t)width;
        }
        midpoint(end[0], end[1], width, extra + i * (size_t)width);
    }
}

void caster_fill(const struct caster *caster, const struct geometry *geometry, float (*position)[3],
                 float (*uv)[2]) {
    struct caster_part all = {0, caster->extra_count};
    fill(caster, all, *geometry->position, 3, *position);
    if (uv)
        fill(caster, all, *geometry->uv, 2, *uv);
}

void caster_fill_part(const struct caster *caster, const struct geometry *geometry, int part,
                      float (*position)[3]) {
    fill(caster, caster->parts[part], *geometry->position, 3, *position);
}

void caster_take_batch(struct caster *caster, const struct geometry *geometry, int batch) {
    const struct geometry_batch *from = &geometry->batches[batch], *to = &caster->batches[batch];
    assert(from->dynamic && from->index_count == to->index_count);
    memcpy(caster->indices + to->first_index, geometry->indices + from->first_index,
           from->index_count * sizeof *caster->indices);
}

/* Static vertices keep their numbers; the extra ones follow those of the geometry. */
static uint32_t renumber(const struct caster *caster, uint32_t vertex, uint32_t new_base) {
    return vertex < caster->base_count ? vertex : vertex - caster->base_count + new_base;
}

void caster_lay_out(struct caster *caster, const struct geometry *geometry) {
    uint32_t base = geometry->vertex_count, first = 0;
    uint32_t *old = caster->indices;
    caster->indices = mem_alloc((size_t)caster->index_count + geometry->index_count, sizeof *old);
    for (uint32_t i = 0; i < caster->extra_count; i++)
        for (int e = 0; e < 2; e++)
            caster->midpoint_of[i][e] = renumber(caster, caster->midpoint_of[i][e], base);
    for (int i = 0; i < caster->batch_count; i++) {
        struct geometry_batch *batch = &caster->batches[i];
        const uint32_t *from = old + batch->first_index;
        batch->first_index = first;
        if (batch->dynamic) {
            batch->index_count = geometry->batches[i].index_count;
            caster_take_batch(caster, geometry, i);
        }
        for (uint32_t k = 0; k < batch->index_count && !batch->dynamic; k++)
            caster->indices[first + k] = renumber(caster, from[k], base);
        first += batch->index_count;
        if (geometry->batches[i].first_index < geometry->opaque_index_count)
            caster->opaque_index_count = first;
    }
    caster->index_count = first;
    caster->base_count = base;
    free(old);
}
