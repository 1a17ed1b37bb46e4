#include "shapes/decimate.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define NONE UINT32_MAX

/* The squared distances to a set of planes: p A p + 2 b p + c, A as xx xy xz yy yz zz. */
struct quadric {
    double a[6], b[3], c;
};

/* A collapse that was possible when both vertices had these stamps. */
struct candidate {
    double cost, place[3];
    uint32_t from, to, from_stamp, to_stamp;
};

struct decimation {
    struct surface *surface;
    double (*position)[3];
    struct quadric *quadrics;
    uint32_t *stamps;      /* of each vertex, counts its changes */
    uint32_t *first;       /* of each vertex, a corner of a triangle there; NONE = it is gone */
    uint32_t *next;        /* of each corner, the next corner at the same vertex */
    uint32_t *marks, mark; /* for counting neighbours */
    struct candidate *heap;
    size_t heap_count, heap_capacity;
    uint32_t triangle_count;
};

/* --- vectors and quadrics --------------------------------------------------------------------- */

static void triangle_normal(const double a[3], const double b[3], const double c[3],
                            double normal[3]) {
    double u[3], v[3];
    for (int k = 0; k < 3; k++) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
    }
    for (int k = 0; k < 3; k++)
        normal[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void add_quadric(struct quadric *sum, const struct quadric *q) {
    for (int i = 0; i < 6; i++)
        sum->a[i] += q->a[i];
    for (int i = 0; i < 3; i++)
        sum->b[i] += q->b[i];
    sum->c += q->c;
}

/* The plane of a triangle, weighted by its area. */
static struct quadric plane_quadric(const double a[3], const double b[3], const double c[3]) {
    double n[3];
    triangle_normal(a, b, c, n);
    double length = sqrt(dot(n, n)), weight = length > 0.0 ? 1.0 / length : 0.0;
    double d = -dot(n, a);
    return (struct quadric){{n[0] * n[0] * weight, n[0] * n[1] * weight, n[0] * n[2] * weight,
                             n[1] * n[1] * weight, n[1] * n[2] * weight, n[2] * n[2] * weight},
                            {n[0] * d * weight, n[1] * d * weight, n[2] * d * weight},
                            d * d * weight};
}

static double quadric_error(const struct quadric *q, const double p[3]) {
    const double *a = q->a;
    return a[0] * p[0] * p[0] + a[3] * p[1] * p[1] + a[5] * p[2] * p[2] +
           2.0 * (a[1] * p[0] * p[1] + a[2] * p[0] * p[2] + a[4] * p[1] * p[2]) +
           2.0 * dot(q->b, p) + q->c;
}

/* Where the error is least, by Cramer's rule; false where that is not well defined. */
static bool quadric_minimum(const struct quadric *q, double p[3]) {
    const double *a = q->a;
    const double rows[3][3] = {{a[0], a[1], a[2]}, {a[1], a[3], a[4]}, {a[2], a[4], a[5]}};
    const double origin[3] = {0.0, 0.0, 0.0};
    double cofactors[3][3];
    for (int k = 0; k < 3; k++)
        triangle_normal(origin, rows[(k + 1) % 3], rows[(k + 2) % 3], cofactors[k]);
    double determinant = dot(rows[0], cofactors[0]), trace = a[0] + a[3] + a[5];
    if (determinant < 1e-4 * trace * trace * trace)
        return false;
    for (int k = 0; k < 3; k++)
        p[k] =
            -(cofactors[0][k] * q->b[0] + cofactors[1][k] * q->b[1] + cofactors[2][k] * q->b[2]) /
            determinant;
    return true;
}

/* --- the heap of candidates ------------------------------------------------------------------- */

static bool cheaper(const struct candidate *a, const struct candidate *b) {
    if (a->cost != b->cost)
        return a->cost < b->cost;
    return a->from != b->from ? a->from < b->from : a->to < b->to;
}

static void push(struct decimation *work, struct candidate candidate) {
    if (work->heap_count == work->heap_capacity) {
        work->heap_capacity = work->heap_capacity ? 2 * work->heap_capacity : 1024;
        work->heap = mem_resize(work->heap, work->heap_capacity, sizeof *work->heap);
    }
    size_t i = work->heap_count++;
    for (; i > 0 && cheaper(&candidate, &work->heap[(i - 1) / 2]); i = (i - 1) / 2)
        work->heap[i] = work->heap[(i - 1) / 2];
    work->heap[i] = candidate;
}

static struct candidate pop(struct decimation *work) {
    struct candidate *heap = work->heap, top = heap[0], last = heap[--work->heap_count];
    size_t i = 0;
    for (size_t child; (child = 2 * i + 1) < work->heap_count; i = child) {
        if (child + 1 < work->heap_count && cheaper(&heap[child + 1], &heap[child]))
            child++;
        if (!cheaper(&heap[child], &last))
            break;
        heap[i] = heap[child];
    }
    heap[i] = last;
    return top;
}

static void push_edge(struct decimation *work, uint32_t from, uint32_t to) {
    struct candidate candidate = {
        .from = from, .to = to, .from_stamp = work->stamps[from], .to_stamp = work->stamps[to]};
    struct quadric sum = work->quadrics[from];
    add_quadric(&sum, &work->quadrics[to]);
    if (!quadric_minimum(&sum, candidate.place))
        for (int k = 0; k < 3; k++)
            candidate.place[k] = 0.5 * (work->position[from][k] + work->position[to][k]);
    candidate.cost = fmax(quadric_error(&sum, candidate.place), 0.0);
    push(work, candidate);
}

/* --- the collapse ----------------------------------------------------------------------------- */

/* The other two corners of a corner's triangle, in order. */
static uint32_t following(uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static bool touches(const struct decimation *work, uint32_t corner, uint32_t vertex) {
    const uint32_t *indices = work->surface->indices;
    return indices[following(corner)] == vertex || indices[following(following(corner))] == vertex;
}

/* Two vertices of a closed surface have exactly two neighbours in common where the edge between
 * them may go (the link condition). */
static bool link_is_plain(struct decimation *work, uint32_t from, uint32_t to) {
    const uint32_t *indices = work->surface->indices;
    uint32_t mark = ++work->mark, shared = 0;
    for (uint32_t c = work->first[to]; c != NONE; c = work->next[c])
        work->marks[indices[following(c)]] = mark;
    for (uint32_t c = work->first[from]; c != NONE; c = work->next[c])
        shared += work->marks[indices[following(c)]] == mark;
    return shared == 2;
}

/* Whether moving the vertex leaves all its triangles, but those with `other`, facing their way. */
static bool keeps_sides(const struct decimation *work, uint32_t vertex, uint32_t other,
                        const double place[3]) {
    const uint32_t *indices = work->surface->indices;
    for (uint32_t c = work->first[vertex]; c != NONE; c = work->next[c]) {
        if (touches(work, c, other))
            continue;
        const double *b = work->position[indices[following(c)]];
        const double *d = work->position[indices[following(following(c))]];
        double before[3], after[3];
        triangle_normal(work->position[vertex], b, d, before);
        triangle_normal(place, b, d, after);
        if (dot(before, after) <= 0.2 * sqrt(dot(before, before) * dot(after, after)))
            return false;
    }
    return true;
}

/* Takes the corners of triangles that hold `other` from the vertex's list. */
static void unlink_between(struct decimation *work, uint32_t vertex, uint32_t other) {
    uint32_t *link = &work->first[vertex];
    while (*link != NONE)
        if (touches(work, *link, other))
            *link = work->next[*link];
        else
            link = &work->next[*link];
}

/* Takes one corner out of its vertex's list. */
static void unlink_corner(struct decimation *work, uint32_t corner) {
    uint32_t *link = &work->first[work->surface->indices[corner]];
    while (*link != corner)
        link = &work->next[*link];
    *link = work->next[corner];
}

/* Moves `to` to the place and hands it all triangles of `from`, but the two between them. */
static void collapse(struct decimation *work, const struct candidate *candidate) {
    uint32_t *indices = work->surface->indices, from = candidate->from, to = candidate->to;
    for (uint32_t c = work->first[from]; c != NONE; c = work->next[c])
        if (touches(work, c, to)) {
            uint32_t third = following(c);
            if (indices[third] == to)
                third = following(third);
            unlink_corner(work, third);
            work->triangle_count--;
        }
    unlink_between(work, to, from);
    uint32_t *end = &work->first[to];
    while (*end != NONE)
        end = &work->next[*end];
    /* Their corners still carry the names `from` and `to`, by which they are told apart. */
    unlink_between(work, from, to);
    *end = work->first[from];
    for (uint32_t c = work->first[from]; c != NONE; c = work->next[c])
        indices[c] = to;
    work->first[from] = NONE;
    memcpy(work->position[to], candidate->place, sizeof work->position[to]);
    add_quadric(&work->quadrics[to], &work->quadrics[from]);
    work->stamps[to]++;
    work->stamps[from]++;
}

static bool is_current(const struct decimation *work, const struct candidate *candidate) {
    return work->stamps[candidate->from] == candidate->from_stamp &&
           work->stamps[candidate->to] == candidate->to_stamp;
}

static void collapse_until(struct decimation *work, uint32_t triangle_count) {
    while (work->triangle_count > triangle_count && work->heap_count > 0) {
        struct candidate candidate = pop(work);
        uint32_t from = candidate.from, to = candidate.to;
        if (!is_current(work, &candidate) || !link_is_plain(work, from, to) ||
            !keeps_sides(work, from, to, candidate.place) ||
            !keeps_sides(work, to, from, candidate.place))
            continue;
        collapse(work, &candidate);
        for (uint32_t c = work->first[to]; c != NONE; c = work->next[c])
            push_edge(work, to, work->surface->indices[following(c)]);
    }
}

/* --- start and end ---------------------------------------------------------------------------- */

static void begin(struct decimation *work, struct surface *surface) {
    uint32_t vertices = surface->vertex_count, corners = surface->index_count;
    *work = (struct decimation){.surface = surface,
                                .position = mem_alloc(vertices, sizeof *work->position),
                                .quadrics = mem_alloc(vertices, sizeof *work->quadrics),
                                .stamps = mem_alloc(vertices, sizeof *work->stamps),
                                .first = mem_alloc(vertices, sizeof *work->first),
                                .next = mem_alloc(corners, sizeof *work->next),
                                .marks = mem_alloc(vertices, sizeof *work->marks),
                                .triangle_count = corners / 3};
    for (uint32_t i = 0; i < vertices; i++) {
        work->first[i] = NONE;
        for (int k = 0; k < 3; k++)
            work->position[i][k] = (double)surface->position[i][k];
    }
    for (uint32_t c = 0; c < corners; c++) {
        uint32_t vertex = surface->indices[c];
        work->next[c] = work->first[vertex];
        work->first[vertex] = c;
    }
    for (uint32_t c = 0; c < corners; c++) {
        const uint32_t *v = surface->indices + c - c % 3;
        struct quadric q =
            plane_quadric(work->position[v[0]], work->position[v[1]], work->position[v[2]]);
        add_quadric(&work->quadrics[surface->indices[c]], &q);
    }
    for (uint32_t c = 0; c < corners; c++)
        if (surface->indices[c] < surface->indices[following(c)])
            push_edge(work, surface->indices[c], surface->indices[following(c)]);
}

/* Writes what is left back into the surface, vertices and triangles in their old order. */
static void finish(struct decimation *work) {
    struct surface *surface = work->surface;
    bool *alive = mem_alloc(surface->index_count, sizeof *alive);
    uint32_t *renamed = work->marks, vertices = 0, corners = 0;
    for (uint32_t i = 0; i < surface->vertex_count; i++) {
        for (uint32_t c = work->first[i]; c != NONE; c = work->next[c])
            alive[c] = true;
        if (work->first[i] == NONE)
            continue;
        for (int k = 0; k < 3; k++)
            surface->position[vertices][k] = (float)work->position[i][k];
        renamed[i] = vertices++;
    }
    for (uint32_t c = 0; c < surface->index_count; c++)
        if (alive[c])
            surface->indices[corners++] = renamed[surface->indices[c]];
    surface->vertex_count = vertices;
    surface->index_count = corners;
    free(alive);
}

void decimate(struct surface *surface, uint32_t triangle_count) {
    struct decimation work;
    begin(&work, surface);
    collapse_until(&work, triangle_count);
    finish(&work);
    free(work.position);
    free(work.quadrics);
    free(work.stamps);
    free(work.first);
    free(work.next);
    free(work.marks);
    free(work.heap);
}
