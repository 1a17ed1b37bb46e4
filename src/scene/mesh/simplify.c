#include "scene/mesh/simplify.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "base/unit.h"
#include "scene/mesh/levels.h"
#include "scene/mesh/primitive.h"
#include "scene/mesh/weld.h"

#include <stdlib.h>
#include <string.h>

/* A small thing in a large scene keeps its shape: it strays at most so far, over its diagonal. In
 * a scene of more triangles it strays farther in proportion, so that their number has a bound. */
static const float part_fraction = 0.0025F, part_fraction_triangles = 1 << 20;

/* How much more than a triangle's plane the line of a border counts. */
static const float border_weight = 10;

/* In one collapse no triangle turns by more than this cosine. */
static const float least_cosine = 0.4F;

/* The normal that a vertex collapses onto is within this cosine, where normals count. */
static const float least_normal_cosine = 0.97F;

/* Casters may fall back behind what they stand for, but in one collapse come before the vertex that
 * it takes away by no more than this much of the error: maps set them back as much. A face that is
 * seen from inside, or from both sides, has fewer triangles the more this is. */
static const float advance = 0.5F;

/* Of collapses that cost alike, short edges go first, which keeps triangles round. */
static const float length_weight = 0.01F;

/* Passes over a mesh. Meshes take up to 40; a chain that shrinks only from its ends would take one
 * for each of its triangles. */
enum { PASSES_MAX = 128 };

/* A vertex with more neighbours stays. */
enum { RING_MAX = 64 };

static const uint32_t none = UINT32_MAX;

/* A sum of squared distances from planes, each with a weight: x' A x + 2 b' x + c. */
struct quadric {
    double a[6]; /* xx, yy, zz, xy, xz, yz */
    double b[3], c, weight;
};

struct patch {
    float (*position)[3], (*normal)[3];
    const bool *locked;
    uint32_t (*triangles)[3];
    struct quadric *quadrics; /* of each vertex: the surface that it stands for */
    uint32_t vertex_count, triangle_count;
    uint32_t left;            /* triangles that are not flat */
    uint32_t *first, *around; /* the triangles of vertex v: around[first[v]] .. [first[v + 1]] */
    struct collapse *best;    /* of each vertex */
    bool *touched;            /* by a collapse of this pass */
    uint32_t *moved_to;
    struct simplify_desc desc;
};

struct collapse {
    uint32_t from, to; /* none: there is no such collapse */
    float order;       /* what comes first */
};

struct neighbour {
    uint32_t vertex;
    int triangles; /* of the edge to it */
};

struct ring {
    struct neighbour items[RING_MAX];
    int count;
};

/* --- connectivity ----------------------------------------------------------------------------- */

static void find_around(struct patch *patch) {
    uint32_t *first = patch->first;
    memset(first, 0, (patch->vertex_count + 2) * sizeof *first);
    for (uint32_t t = 0; t < patch->triangle_count; t++)
        for (int c = 0; c < 3; c++)
            first[patch->triangles[t][c] + 2]++;
    for (uint32_t v = 1; v < patch->vertex_count + 2; v++)
        first[v] += first[v - 1];
    for (uint32_t t = 0; t < patch->triangle_count; t++)
        for (int c = 0; c < 3; c++)
            patch->around[first[patch->triangles[t][c] + 1]++] = t;
}

static bool has_corner(const uint32_t triangle[3], uint32_t vertex) {
    return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

static bool ring_add(struct ring *ring, uint32_t vertex) {
    for (int i = 0; i < ring->count; i++)
        if (ring->items[i].vertex == vertex) {
            ring->items[i].triangles++;
            return true;
        }
    if (ring->count == RING_MAX)
        return false;
    ring->items[ring->count++] = (struct neighbour){vertex, 1};
    return true;
}

/* False where there are too many. */
static bool list_ring(const struct patch *patch, uint32_t vertex, struct ring *ring) {
    ring->count = 0;
    for (uint32_t i = patch->first[vertex]; i < patch->first[vertex + 1]; i++)
        for (int c = 0; c < 3; c++) {
            uint32_t other = patch->triangles[patch->around[i]][c];
            if (other != vertex && !ring_add(ring, other))
                return false;
        }
    return true;
}

static uint32_t count_around(const struct patch *patch, uint32_t vertex) {
    return patch->first[vertex + 1] - patch->first[vertex];
}

/* Of the ends, that with fewer triangles is asked: a fan may have any number around its centre. */
static bool adjacent(const struct patch *patch, uint32_t a, uint32_t b) {
    uint32_t few = count_around(patch, a) < count_around(patch, b) ? a : b, other = a ^ b ^ few;
    for (uint32_t i = patch->first[few]; i < patch->first[few + 1]; i++)
        if (has_corner(patch->triangles[patch->around[i]], other))
            return true;
    return false;
}

/* Whether the surface stays a surface: the ends have no neighbours in common but those of the
 * edge's own triangles [Dey et al. 1999, the link condition]. */
static bool keeps_topology(const struct patch *patch, const struct ring *ring,
                           const struct neighbour *to) {
    int common = 0;
    for (int i = 0; i < ring->count; i++)
        if (ring->items[i].vertex != to->vertex)
            common += adjacent(patch, ring->items[i].vertex, to->vertex);
    return common == to->triangles;
}

/* --- cost ------------------------------------------------------------------------------------- */

static float triangle_normal(const float *a, const float *b, const float *c, vec3 normal) {
    vec3 edges[2];
    glm_vec3_sub((float *)b, (float *)a, edges[0]);
    glm_vec3_sub((float *)c, (float *)a, edges[1]);
    glm_vec3_cross(edges[0], edges[1], normal);
    return glm_vec3_norm(normal);
}

static void add_plane(struct quadric *quadric, const vec3 normal, const float *point,
                      double weight) {
    double x = normal[0], y = normal[1], z = normal[2];
    double d = -(x * point[0] + y * point[1] + z * point[2]);
    const double a[6] = {x * x, y * y, z * z, x * y, x * z, y * z}, b[3] = {x * d, y * d, z * d};
    for (int i = 0; i < 6; i++)
        quadric->a[i] += weight * a[i];
    for (int i = 0; i < 3; i++)
        quadric->b[i] += weight * b[i];
    quadric->c += weight * d * d;
    quadric->weight += weight;
}

static void add_quadric(struct quadric *sum, const struct quadric *quadric) {
    for (int i = 0; i < 6; i++)
        sum->a[i] += quadric->a[i];
    for (int i = 0; i < 3; i++)
        sum->b[i] += quadric->b[i];
    sum->c += quadric->c;
    sum->weight += quadric->weight;
}

/* The mean distance of a point from the planes, root of the mean square. */
static float quadric_distance(const struct quadric *quadric, const float *point) {
    const double *a = quadric->a, *b = quadric->b, x = point[0], y = point[1], z = point[2];
    double sum = a[0] * x * x + a[1] * y * y + a[2] * z * z +
                 2 * (a[3] * x * y + a[4] * x * z + a[5] * y * z + b[0] * x + b[1] * y + b[2] * z) +
                 quadric->c;
    return (float)sqrt(fmax(sum, 0) / fmax(quadric->weight, 1e-300));
}

static float error_at(const struct patch *patch, uint32_t vertex) {
    return patch->desc.errors ? patch->desc.errors[vertex] : patch->desc.error;
}

/* Whether a triangle may move one of its corners: not where it turns over or grows too long, nor
 * where it comes to lie before the corner, which would be in its shadow. */
static bool may_move(const struct patch *patch, const uint32_t triangle[3], uint32_t from,
                     uint32_t to) {
    int c = triangle[0] == from ? 0 : triangle[1] == from ? 1 : 2;
    float *p = patch->position[triangle[(c + 1) % 3]];
    float *q = patch->position[triangle[(c + 2) % 3]];
    float *end = patch->position[to];
    vec3 old, made;
    float cosine = least_cosine * triangle_normal(patch->position[from], p, q, old) *
                   triangle_normal(end, p, q, made);
    vec3 left;
    glm_vec3_sub(patch->position[from], p, left);
    return glm_vec3_dot(old, made) > cosine &&
           glm_vec3_dot(left, made) >= -advance * error_at(patch, from) * glm_vec3_norm(made);
}

static bool all_may_move(const struct patch *patch, uint32_t from, uint32_t to) {
    for (uint32_t i = patch->first[from]; i < patch->first[from + 1]; i++) {
        const uint32_t *triangle = patch->triangles[patch->around[i]];
        if (!has_corner(triangle, to) && !may_move(patch, triangle, from, to))
            return false;
    }
    return true;
}

/* The ends of the border at a vertex: 0 or 2; or else it is no plain surface there. */
static int count_border(const struct ring *ring) {
    int count = 0;
    for (int i = 0; i < ring->count; i++) {
        if (ring->items[i].triangles > 2)
            return -1;
        count += ring->items[i].triangles == 1;
    }
    return count;
}

static bool like_normals(const struct patch *patch, uint32_t a, uint32_t b) {
    return !patch->normal ||
           glm_vec3_dot(patch->normal[a], patch->normal[b]) >= least_normal_cosine;
}

/* Returns the cost of a collapse; INFINITY if the vertex would move too far. The square root of the
 * quadric's weight makes vertices of small surfaces go first. */
static float order_of(const struct patch *patch, uint32_t from, uint32_t to) {
    const struct quadric *quadric = &patch->quadrics[from];
    float strayed = quadric_distance(quadric, patch->position[to]);
    float length = glm_vec3_distance(patch->position[from], patch->position[to]);
    float order = sqrtf((float)quadric->weight) * (strayed + length_weight * length);
    return strayed <= error_at(patch, from) && order < INFINITY ? order : INFINITY;
}

/* Finds the cheapest collapse of a vertex that is allowed. A border vertex moves only along its
 * border. The cost is cheap and the test is not, so collapses are tested in order of cost. */
static struct collapse best_collapse(const struct patch *patch, uint32_t from) {
    struct ring ring;
    float orders[RING_MAX];
    if ((patch->locked && patch->locked[from]) || !list_ring(patch, from, &ring))
        return (struct collapse){from, none, INFINITY};
    int border = count_border(&ring);
    if (border != 0 && (border != 2 || patch->desc.holds_borders))
        return (struct collapse){from, none, INFINITY};
    for (int i = 0; i < ring.count; i++) {
        uint32_t to = ring.items[i].vertex;
        bool along = !border || ring.items[i].triangles == 1;
        orders[i] = along && like_normals(patch, from, to) ? order_of(patch, from, to) : INFINITY;
    }
    for (;;) {
        int best = 0;
        for (int i = 1; i < ring.count; i++)
            best = orders[i] < orders[best] ? i : best;
        if (ring.count == 0 || orders[best] == INFINITY)
            return (struct collapse){from, none, INFINITY};
        uint32_t to = ring.items[best].vertex;
        if (all_may_move(patch, from, to) && keeps_topology(patch, &ring, &ring.items[best]))
            return (struct collapse){from, to, orders[best]};
        orders[best] = INFINITY;
    }
}

/* --- passes ----------------------------------------------------------------------------------- */

static int compare_order(const void *a, const void *b) {
    const struct collapse *x = a, *y = b;
    if (x->order != y->order)
        return x->order < y->order ? -1 : 1;
    return x->from < y->from ? -1 : x->from > y->from;
}

static bool is_flat(const uint32_t triangle[3]) {
    return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

static void apply(struct patch *patch, const struct collapse *collapse) {
    for (uint32_t i = patch->first[collapse->from]; i < patch->first[collapse->from + 1]; i++) {
        uint32_t *triangle = patch->triangles[patch->around[i]];
        for (int c = 0; c < 3; c++)
            patch->touched[triangle[c]] = true;
        for (int c = 0; c < 3; c++)
            if (triangle[c] == collapse->from)
                triangle[c] = collapse->to;
        patch->left -= is_flat(triangle);
    }
    add_quadric(&patch->quadrics[collapse->to], &patch->quadrics[collapse->from]);
    patch->moved_to[collapse->from] = collapse->to;
}

static void drop_flat(struct patch *patch) {
    uint32_t count = 0;
    for (uint32_t t = 0; t < patch->triangle_count; t++)
        if (!is_flat(patch->triangles[t]))
            memmove(patch->triangles[count++], patch->triangles[t], sizeof *patch->triangles);
    patch->triangle_count = patch->left = count;
}

/* Looks again where the last pass has changed something. */
static uint32_t list_collapses(struct patch *patch, struct collapse *list) {
    uint32_t count = 0;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        struct collapse *best = &patch->best[v];
        if (patch->touched[v] || (best->to != none && patch->touched[best->to]))
            *best = best_collapse(patch, v);
        if (best->to != none)
            list[count++] = *best;
    }
    return count;
}

/* The cheaper half of what there is, or all where borders stay, but for what touches another. False
 * when there is nothing, or the triangles are few enough. */
static bool collapse_some(struct patch *patch, struct collapse *list) {
    find_around(patch);
    uint32_t count = list_collapses(patch, list);
    qsort(list, count, sizeof *list, compare_order);
    memset(patch->touched, 0, patch->vertex_count);
    uint32_t most = patch->desc.holds_borders ? count : (count + 1) / 2;
    for (uint32_t i = 0; i < most && patch->left > patch->desc.triangle_count; i++)
        if (!patch->touched[list[i].from] && !patch->touched[list[i].to])
            apply(patch, &list[i]);
    drop_flat(patch);
    return count > 0 && patch->left > patch->desc.triangle_count;
}

/* A border is held by a plane through each of its edges, upright on the triangle. */
static void add_border(struct patch *patch, uint32_t a, uint32_t b, vec3 normal) {
    vec3 edge, upright;
    glm_vec3_sub(patch->position[b], patch->position[a], edge);
    float length = glm_vec3_norm(edge);
    vec3_unit_cross(edge, normal, upright);
    add_plane(&patch->quadrics[a], upright, patch->position[a], border_weight * length);
    add_plane(&patch->quadrics[b], upright, patch->position[a], border_weight * length);
}

/* Whether one triangle alone has the edge. */
static bool is_border(const struct patch *patch, uint32_t a, uint32_t b) {
    uint32_t few = count_around(patch, a) < count_around(patch, b) ? a : b, other = a ^ b ^ few;
    int count = 0;
    for (uint32_t i = patch->first[few]; i < patch->first[few + 1] && count < 2; i++)
        count += has_corner(patch->triangles[patch->around[i]], other);
    return count == 1;
}

/* Planes count by the root of their area, as lengths do, so that small things on large
 * ones count. */
static void make_quadrics(struct patch *patch) {
    find_around(patch);
    for (uint32_t t = 0; t < patch->triangle_count; t++) {
        const uint32_t *corner = patch->triangles[t];
        vec3 normal;
        float area = triangle_normal(patch->position[corner[0]], patch->position[corner[1]],
                                     patch->position[corner[2]], normal);
        vec3_unit(normal);
        for (int c = 0; c < 3; c++) {
            add_plane(&patch->quadrics[corner[c]], normal, patch->position[corner[0]], sqrt(area));
            if (is_border(patch, corner[c], corner[(c + 1) % 3]))
                add_border(patch, corner[c], corner[(c + 1) % 3], normal);
        }
    }
}

static void patch_init(struct patch *patch, const struct simplify_mesh *mesh,
                       const struct simplify_desc *desc, uint32_t *moved_to) {
    uint32_t vertices = mesh->vertex_count, triangles = mesh->index_count / 3;
    *patch = (struct patch){
        .position = mesh->position,
        .normal = mesh->normal,
        .locked = mesh->locked,
        .triangles = mem_alloc(triangles, sizeof *patch->triangles),
        .quadrics = mem_alloc(vertices, sizeof *patch->quadrics),
        .vertex_count = vertices,
        .triangle_count = triangles,
        .first = mem_alloc((size_t)vertices + 2, sizeof *patch->first),
        .around = mem_alloc((size_t)triangles * 3, sizeof *patch->around),
        .best = mem_alloc(vertices, sizeof *patch->best),
        .touched = mem_alloc(vertices, sizeof *patch->touched),
        .moved_to = moved_to,
        .desc = *desc,
    };
    memset(patch->touched, true, vertices);
    for (uint32_t v = 0; v < vertices; v++)
        moved_to[v] = v;
    memcpy(patch->triangles, mesh->indices, triangles * sizeof *patch->triangles);
    drop_flat(patch);
    make_quadrics(patch);
}

static void patch_free(struct patch *patch) {
    mem_free(patch->triangles, patch->quadrics, patch->first, patch->around, patch->best,
             patch->touched);
}

void simplify_mesh(const struct simplify_mesh *mesh, const struct simplify_desc *desc,
                   uint32_t *moved_to) {
    struct patch patch;
    patch_init(&patch, mesh, desc, moved_to);
    struct collapse *list = mem_alloc(mesh->vertex_count, sizeof *list);
    for (int pass = 0; pass < PASSES_MAX && collapse_some(&patch, list);)
        pass++;
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        while (moved_to[moved_to[v]] != moved_to[v])
            moved_to[v] = moved_to[moved_to[v]];
    free(list);
    patch_free(&patch);
}

/* --- geometry --------------------------------------------------------------------------------- */

/* A part, and what decides its triangles: parts of one primitive that agree share them. */
struct subject {
    const struct geometry_part *part;
    const struct primitive *primitive; /* NULL: the part's own vertices, in the world */
    float error;                       /* in the primitive's space */
};

struct work {
    const struct geometry *geometry;
    struct subject *subjects;
    uint32_t *first; /* subjects that agree follow each other: where they begin, and the end */
    float fraction;
    const bool *shared;
    const struct levels *levels;
    uint32_t *moved_to;
};

float simplify_scale(const float world[16]) {
    return fmaxf(glm_vec3_norm((float *)world),
                 fmaxf(glm_vec3_norm((float *)world + 4), glm_vec3_norm((float *)world + 8)));
}

/* In steps of a quarter of an octave, so that instances of nearly one size agree. */
static float local_error(float error, float scale) {
    return exp2f(floorf(4 * log2f(error / scale)) / 4);
}

static bool has_shared(const bool *shared, const struct geometry_part *part) {
    return memchr(shared + part->first_vertex, true, part->vertex_count) != NULL;
}

static struct subject subject_of(const struct geometry *geometry, const struct simplify_desc *desc,
                                 const bool *shared, const struct geometry_part *part) {
    struct subject subject = {part, NULL, desc->error};
    if (!desc->scene || has_shared(shared, part))
        return subject;
    subject.primitive = geometry_primitive(desc->scene, part);
    subject.error = local_error(desc->error, simplify_scale(geometry->pose.worlds[part->node]));
    return subject;
}

static int compare_shape(const struct subject *x, const struct subject *y) {
    if (x->primitive != y->primitive)
        return (uintptr_t)x->primitive < (uintptr_t)y->primitive ? -1 : 1;
    return (x->error > y->error) - (x->error < y->error);
}

static int compare_subjects(const void *a, const void *b) {
    const struct subject *x = a, *y = b;
    int order = compare_shape(x, y);
    return order ? order : (x->part > y->part) - (x->part < y->part);
}

/* In the primitive's space. */
static float diagonal_of(const struct subject *subject) {
    const struct geometry_part *part = subject->part;
    return subject->primitive
               ? primitive_diagonal(subject->primitive)
               : glm_vec3_distance((float *)part->bounds_min, (float *)part->bounds_max);
}

/* Welds before it simplifies. The caller frees the result. */
static uint32_t *move_vertices(const struct work *work, const struct subject *subject) {
    const struct primitive *primitive = subject->primitive;
    uint32_t base = subject->part->first_vertex, count = subject->part->vertex_count;
    uint32_t index_count = subject->part->index_count, from = primitive ? 0 : base;
    const uint32_t *corner =
        primitive ? primitive->indices : work->geometry->indices + subject->part->first_index;
    float(*position)[3] = primitive ? primitive->position : work->geometry->position + base;
    uint32_t *first = mem_alloc(count, sizeof *first), *moved = mem_alloc(count, sizeof *moved);
    uint32_t *indices = mem_alloc(index_count, sizeof *indices);
    bool *locked = mem_alloc(count, sizeof *locked);
    weld_vertices(position, count, first);
    for (uint32_t v = 0; v < count; v++)
        locked[first[v]] |= work->shared[base + v];
    float error = fminf(subject->error, work->fraction * diagonal_of(subject));
    const uint32_t *begun =
        primitive && work->levels ? levels_moved(work->levels, primitive, error / 2) : NULL;
    for (uint32_t v = 0; v < count && begun; v++)
        moved[v] = first[begun[v]];
    memcpy(first, begun ? moved : first, count * sizeof *first);
    for (uint32_t k = 0; k < index_count; k++)
        indices[k] = first[corner[k] - from];
    struct simplify_mesh mesh = {position, indices, locked, count, index_count, NULL};
    simplify_mesh(&mesh, &(struct simplify_desc){.error = error}, moved);
    for (uint32_t v = 0; v < count; v++)
        first[v] = moved[first[v]];
    mem_free(moved, indices, locked);
    return first;
}

static void simplify_subjects(void *context, size_t number) {
    const struct work *work = context;
    uint32_t *moved = move_vertices(work, &work->subjects[work->first[number]]);
    for (uint32_t i = work->first[number]; i < work->first[number + 1]; i++) {
        const struct geometry_part *part = work->subjects[i].part;
        for (uint32_t v = 0; v < part->vertex_count; v++)
            work->moved_to[part->first_vertex + v] = part->first_vertex + moved[v];
    }
    free(moved);
}

/* Returns how many different ones there are. */
static uint32_t list_subjects(struct work *work, const struct simplify_desc *desc) {
    const struct geometry *geometry = work->geometry;
    uint32_t count = 0, different = 0;
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        if (part->rigid && part->index_count && part->first_index < geometry->opaque_index_count)
            work->subjects[count++] = subject_of(geometry, desc, work->shared, part);
    }
    qsort(work->subjects, count, sizeof *work->subjects, compare_subjects);
    for (uint32_t i = 0; i < count; i++)
        if (i == 0 || !work->subjects[i].primitive ||
            compare_shape(&work->subjects[i - 1], &work->subjects[i]) != 0)
            work->first[different++] = i;
    work->first[different] = count;
    return different;
}

uint32_t *simplify_geometry(const struct geometry *geometry, const struct simplify_desc *desc) {
    size_t parts = (size_t)geometry->part_count;
    uint32_t *moved_to = mem_alloc(geometry->vertex_count, sizeof *moved_to);
    for (uint32_t v = 0; v < geometry->vertex_count; v++)
        moved_to[v] = v;
    bool *shared = weld_find_shared(geometry);
    float excess = (float)geometry->index_count / (3 * part_fraction_triangles);
    struct work work = {
        .geometry = geometry,
        .subjects = mem_alloc(parts, sizeof *work.subjects),
        .first = mem_alloc(parts + 1, sizeof *work.first),
        .fraction = part_fraction * fmaxf(1, excess),
        .shared = shared,
        .levels = desc->levels,
        .moved_to = moved_to,
    };
    parallel_for(list_subjects(&work, desc), 0, simplify_subjects, &work);
    mem_free(shared, work.subjects, work.first);
    return moved_to;
}
