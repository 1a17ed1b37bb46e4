#include "scene/mesh/levels.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "scene/mesh/primitive.h"
#include "scene/mesh/simplify.h"

#include <cglm/cglm.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Error of each level over the diagonal of its piece; an uncut primitive is one piece. It includes
 * the errors of the levels before. */
static const float level_errors[LEVEL_COUNT] = {1 / 512.F, 1 / 256.F, 1 / 128.F};

/* A level of nearly as many triangles as the one before is none. */
static const float most_left = .8F;

/* Parts of fewer triangles draw them all: a draw costs as much. */
enum { PART_TRIANGLES = 1024 };

/* Triangles of a piece, and the fewest pieces into which a part is cut. Vertices that pieces share
 * stay. */
enum { PIECE_TRIANGLES = 2048, CUT_PIECES = 16 };

#define SHARED UINT32_MAX /* an owner: several pieces */

/* Consecutive triangles of a primitive. */
struct piece {
    float diagonal;
    uint32_t left, drawn; /* indices of the last level, and of the coarsest that is drawn */
    bool has[LEVEL_COUNT];
};

struct level_shape {
    const struct primitive *primitive;
    struct piece *pieces;
    uint32_t piece_count;
    uint32_t *moved[LEVEL_COUNT]; /* for each vertex the one it collapses onto */
};

struct work {
    const struct geometry *geometry;
    struct levels *levels;
    const struct scene *scene;
};

/* --- shapes ----------------------------------------------------------------------------------- */

/* Writes the triangles that are left, and returns how many indices these are. */
static uint32_t move_triangles(const uint32_t *from, uint32_t count, const uint32_t *moved,
                               uint32_t base, uint32_t *to) {
    uint32_t left = 0;
    for (uint32_t k = 0; k < count; k += 3) {
        uint32_t corner[3];
        for (int c = 0; c < 3; c++)
            corner[c] = moved[from[k + (uint32_t)c] - base] + base;
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            continue;
        memcpy(to + left, corner, sizeof corner);
        left += 3;
    }
    return left;
}

/* Returns the first index of piece `number` of so many. */
static uint32_t piece_begin(const struct primitive *primitive, uint32_t pieces, uint32_t number) {
    uint64_t triangles = (uint64_t)primitive->index_count / 3;
    return 3 * (uint32_t)(triangles * number / pieces);
}

/* Writes for each vertex its piece, from 1, or SHARED. Returns how many vertices are shared. */
static uint32_t find_owners(const struct primitive *primitive, uint32_t pieces, uint32_t *owners) {
    uint32_t shared = 0;
    for (uint32_t p = 0; p < pieces; p++)
        for (uint32_t k = piece_begin(primitive, pieces, p);
             k < piece_begin(primitive, pieces, p + 1); k++) {
            uint32_t *owner = &owners[primitive->indices[k]];
            if (*owner == 0)
                *owner = p + 1;
            if (*owner != p + 1 && *owner != SHARED) {
                *owner = SHARED;
                shared++;
            }
        }
    return shared;
}

/* Cuts the primitive. Returns for each vertex its piece's diagonal; -1: it is shared. Triangles in
 * no spatial order would share most vertices, which stay: such a primitive is one piece. */
static float *cut_shape(struct level_shape *shape) {
    const struct primitive *primitive = shape->primitive;
    uint32_t vertices = (uint32_t)primitive->vertex_count;
    uint32_t pieces = (uint32_t)primitive->index_count / 3 / PIECE_TRIANGLES;
    float *sizes = mem_alloc(vertices, sizeof *sizes);
    uint32_t *owners = mem_alloc(vertices, sizeof *owners);
    if (pieces < CUT_PIECES || find_owners(primitive, pieces, owners) > vertices / 2) {
        pieces = 1;
        memset(owners, 0, vertices * sizeof *owners);
        find_owners(primitive, pieces, owners);
    }
    shape->piece_count = pieces;
    shape->pieces = mem_alloc(pieces, sizeof *shape->pieces);
    for (uint32_t p = 0; p < pieces; p++) {
        struct primitive part = *primitive;
        uint32_t begin = piece_begin(primitive, pieces, p);
        part.indices += begin;
        part.index_count = (int)(piece_begin(primitive, pieces, p + 1) - begin);
        uint32_t count = (uint32_t)part.index_count;
        shape->pieces[p] =
            (struct piece){.diagonal = primitive_diagonal(&part), .left = count, .drawn = count};
    }
    for (uint32_t v = 0; v < vertices; v++)
        sizes[v] = owners[v] == SHARED ? -1 : owners[v] ? shape->pieces[owners[v] - 1].diagonal : 0;
    free(owners);
    return sizes;
}

/* indices, count: of the level before, then of this one, piece by piece. */
static void make_level(struct level_shape *shape, int level, uint32_t *indices, uint32_t *count,
                       const float *sizes) {
    const struct primitive *primitive = shape->primitive;
    uint32_t vertices = (uint32_t)primitive->vertex_count, begin = 0;
    uint32_t *moved = mem_alloc(vertices, sizeof *moved);
    float *errors = mem_alloc(vertices, sizeof *errors);
    float before = level > 0 ? level_errors[level - 1] : 0;
    for (uint32_t v = 0; v < vertices; v++)
        errors[v] = (level_errors[level] - before) * sizes[v];
    struct simplify_mesh mesh = {primitive->position, indices, NULL, vertices, *count,
                                 primitive->normal};
    simplify_mesh(&mesh, &(struct simplify_desc){.errors = errors, .holds_borders = true}, moved);
    *count = 0;
    for (uint32_t p = 0; p < shape->piece_count; p++) {
        struct piece *piece = &shape->pieces[p];
        uint32_t left = move_triangles(indices + begin, piece->left, moved, 0, indices + *count);
        begin += piece->left;
        *count += left;
        piece->left = left;
        piece->has[level] = (float)left < most_left * (float)piece->drawn;
        if (piece->has[level])
            piece->drawn = left;
    }
    for (uint32_t v = 0; v < vertices && level > 0; v++)
        moved[v] = moved[shape->moved[level - 1][v]];
    shape->moved[level] = moved;
    free(errors);
}

static void make_shape(void *context, size_t number) {
    struct level_shape *shape = &((struct levels *)context)->shapes[number];
    uint32_t count = (uint32_t)shape->primitive->index_count;
    uint32_t *indices = mem_copy(shape->primitive->indices, count, sizeof *indices);
    float *sizes = cut_shape(shape);
    for (int level = 0; level < LEVEL_COUNT; level++)
        make_level(shape, level, indices, &count, sizes);
    mem_free(indices, sizes);
}

static int compare_shapes(const void *a, const void *b) {
    uintptr_t x = (uintptr_t)((const struct level_shape *)a)->primitive;
    uintptr_t y = (uintptr_t)((const struct level_shape *)b)->primitive;
    return (x > y) - (x < y);
}

static const struct level_shape *find_shape(const struct levels *levels,
                                            const struct primitive *primitive) {
    struct level_shape key = {.primitive = primitive};
    return bsearch(&key, levels->shapes, (size_t)levels->shape_count, sizeof key, compare_shapes);
}

/* --- parts ------------------------------------------------------------------------------------ */

static bool is_textured(const struct material *material) {
    return material->base_color_texture >= 0 || material->emission_texture >= 0 ||
           material->metal_roughness_texture >= 0 || material->normal_texture >= 0;
}

static bool has_levels(const struct work *work, const struct geometry_part *part) {
    if (!part->rigid || part->first_index >= work->geometry->opaque_index_count ||
        part->index_count < 3 * PART_TRIANGLES)
        return false;
    const struct primitive *primitive = geometry_primitive(work->scene, part);
    return !primitive->color && !primitive->flat &&
           !is_textured(&work->scene->materials[primitive->material]);
}

static void list_shapes(struct work *work) {
    struct levels *levels = work->levels;
    const struct geometry *geometry = work->geometry;
    size_t count = 0;
    levels->shapes = mem_alloc((size_t)geometry->part_count, sizeof *levels->shapes);
    for (int i = 0; i < geometry->part_count; i++)
        if (has_levels(work, &geometry->parts[i]))
            levels->shapes[count++].primitive =
                geometry_primitive(work->scene, &geometry->parts[i]);
    qsort(levels->shapes, count, sizeof *levels->shapes, compare_shapes);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || levels->shapes[i].primitive != levels->shapes[i - 1].primitive)
            levels->shapes[levels->shape_count++].primitive = levels->shapes[i].primitive;
}

static int compare_parts(const void *a, const void *b) {
    uint32_t x = ((const struct level_part *)a)->first_index;
    uint32_t y = ((const struct level_part *)b)->first_index;
    return (x > y) - (x < y);
}

static void list_pieces(struct work *work, int number) {
    const struct geometry_part *part = &work->geometry->parts[number];
    const struct primitive *primitive = geometry_primitive(work->scene, part);
    uint32_t pieces = find_shape(work->levels, primitive)->piece_count;
    for (uint32_t p = 0; p < pieces; p++) {
        uint32_t begin = piece_begin(primitive, pieces, p),
                 end = piece_begin(primitive, pieces, p + 1);
        work->levels->parts[work->levels->part_count++] = (struct level_part){
            number, (int)p, .first_index = part->first_index + begin, .index_count = end - begin};
    }
}

static void list_parts(struct work *work) {
    const struct geometry *geometry = work->geometry;
    struct levels *levels = work->levels;
    size_t most = (size_t)geometry->part_count + geometry->index_count / 3 / PIECE_TRIANGLES;
    levels->parts = mem_alloc(most, sizeof *levels->parts);
    for (int i = 0; i < geometry->part_count; i++)
        if (has_levels(work, &geometry->parts[i]))
            list_pieces(work, i);
    qsort(levels->parts, (size_t)levels->part_count, sizeof *levels->parts, compare_parts);
}

/* Returns its level part with indices, which comes first. */
static const struct level_part *find_twin(const struct work *work, const struct level_part *part) {
    const struct geometry_part *parts = work->geometry->parts, *own = &parts[part->part];
    uint32_t back = own->first_index - parts[own->twin].first_index;
    struct level_part key = {.first_index = part->first_index - back};
    return bsearch(&key, work->levels->parts, (size_t)work->levels->part_count, sizeof key,
                   compare_parts);
}

/* Adds its triangles by level, or takes those of its twin. */
static void add_part(const struct work *work, struct level_part *part) {
    const struct geometry_part *own = &work->geometry->parts[part->part];
    const struct level_part *twin = find_twin(work, part);
    const struct level_shape *shape =
        find_shape(work->levels, geometry_primitive(work->scene, own));
    const uint32_t *from = work->geometry->indices + part->first_index;
    const struct piece *piece = &shape->pieces[part->piece];
    float scale = simplify_scale(work->geometry->pose.worlds[own->node]) * piece->diagonal;
    struct levels *levels = work->levels;
    part->base = (int32_t)(own->first_vertex - work->geometry->parts[own->twin].first_vertex);
    for (int l = 0; l < LEVEL_COUNT; l++) {
        part->error[l] = piece->has[l] ? level_errors[l] * scale : INFINITY;
        part->first[l] = twin->first[l];
        part->count[l] = twin->count[l];
        if (!piece->has[l] || twin != part)
            continue;
        part->first[l] = levels->index_count;
        part->count[l] = move_triangles(from, part->index_count, shape->moved[l], own->first_vertex,
                                        levels->indices + part->first[l]);
        levels->index_count += part->count[l];
    }
}

/* Casters begin with it. */
static void keep_coarsest(struct level_shape *shape) {
    for (int l = 0; l + 1 < LEVEL_COUNT; l++) {
        free(shape->moved[l]);
        shape->moved[l] = NULL;
    }
}

void levels_init(struct levels *levels, const struct scene *scene,
                 const struct geometry *geometry) {
    *levels = (struct levels){0};
    struct work work = {.geometry = geometry, .levels = levels, .scene = scene};
    list_shapes(&work);
    parallel_for((size_t)levels->shape_count, 0, make_shape, levels);
    list_parts(&work);
    /* Pages that no triangle fills take no memory. */
    levels->indices =
        mem_alloc((size_t)geometry->index_count * LEVEL_COUNT, sizeof *levels->indices);
    for (int i = 0; i < levels->part_count; i++)
        add_part(&work, &levels->parts[i]);
    levels_measure(levels, geometry);
    for (int i = 0; i < levels->shape_count; i++)
        keep_coarsest(&levels->shapes[i]);
}

void levels_measure(struct levels *levels, const struct geometry *geometry) {
    for (int i = 0; i < levels->part_count; i++) {
        struct level_part *part = &levels->parts[i];
        const struct geometry_part *own = &geometry->parts[part->part];
        if (own->moved <= levels->pose)
            continue;
        glm_vec3_broadcast(FLT_MAX, part->box[0]);
        glm_vec3_broadcast(-FLT_MAX, part->box[1]);
        for (uint32_t k = 0; k < part->index_count; k++) {
            float *position = geometry->position[geometry->indices[part->first_index + k]];
            glm_vec3_minv(part->box[0], position, part->box[0]);
            glm_vec3_maxv(part->box[1], position, part->box[1]);
        }
    }
    levels->pose = geometry->pose_count;
}

void levels_free_indices(struct levels *levels) {
    free(levels->indices);
    levels->indices = NULL;
}

void levels_free(struct levels *levels) {
    levels_free_indices(levels);
    for (int i = 0; i < levels->shape_count; i++) {
        free(levels->shapes[i].pieces);
        for (int l = 0; l < LEVEL_COUNT; l++)
            free(levels->shapes[i].moved[l]);
    }
    mem_free(levels->shapes, levels->parts);
    *levels = (struct levels){0};
}

const uint32_t *levels_moved(const struct levels *levels, const struct primitive *primitive,
                             float error) {
    const struct level_shape *shape = find_shape(levels, primitive);
    float diagonal = 0;
    for (uint32_t p = 0; shape && p < shape->piece_count; p++)
        diagonal = fmaxf(diagonal, shape->pieces[p].diagonal);
    bool fits = shape && level_errors[LEVEL_COUNT - 1] * diagonal <= error;
    return fits ? shape->moved[LEVEL_COUNT - 1] : NULL;
}
