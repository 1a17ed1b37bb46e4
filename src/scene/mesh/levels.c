#include "scene/mesh/levels.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "scene/mesh/primitive.h"
#include "scene/mesh/simplify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Over the diagonal of the primitive. The chain of levels sums up to the last one's error. */
static const float level_errors[LEVEL_COUNT] = {1 / 512.F, 1 / 256.F, 1 / 128.F};

/* A level of nearly as many triangles as the one before is none. */
static const float most_left = .8F;

/* Parts of fewer triangles draw them all: a draw costs as much. */
enum { PART_TRIANGLES = 1024 };

struct level_shape {
    const struct primitive *primitive;
    float diagonal;
    bool has[LEVEL_COUNT];
    uint32_t *moved[LEVEL_COUNT]; /* for each vertex the one it collapses onto */
};

struct work {
    const struct geometry *geometry;
    struct levels *levels;
    const struct primitive **primitives; /* of each part with levels */
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

/* count: indices of the level before, then of this one; drawn: of the coarsest that is drawn. */
static void make_level(struct level_shape *shape, int level, uint32_t *indices, uint32_t *count,
                       uint32_t *drawn) {
    const struct primitive *primitive = shape->primitive;
    uint32_t vertices = (uint32_t)primitive->vertex_count;
    uint32_t *moved = mem_alloc(vertices, sizeof *moved);
    float before = level > 0 ? level_errors[level - 1] : 0;
    struct simplify_mesh mesh = {primitive->position, indices, NULL, vertices, *count,
                                 primitive->normal};
    simplify_mesh(&mesh,
                  &(struct simplify_desc){.error = (level_errors[level] - before) * shape->diagonal,
                                          .holds_borders = true},
                  moved);
    *count = move_triangles(indices, *count, moved, 0, indices);
    shape->has[level] = (float)*count < most_left * (float)*drawn;
    if (shape->has[level])
        *drawn = *count;
    for (uint32_t v = 0; v < vertices && level > 0; v++)
        moved[v] = moved[shape->moved[level - 1][v]];
    shape->moved[level] = moved;
}

static void make_shape(void *context, size_t number) {
    struct level_shape *shape = &((struct levels *)context)->shapes[number];
    uint32_t count = (uint32_t)shape->primitive->index_count, drawn = count;
    uint32_t *indices = mem_copy(shape->primitive->indices, count, sizeof *indices);
    shape->diagonal = primitive_diagonal(shape->primitive);
    for (int level = 0; level < LEVEL_COUNT; level++)
        make_level(shape, level, indices, &count, &drawn);
    free(indices);
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

static void list_shapes(struct work *work) {
    struct levels *levels = work->levels;
    size_t count = (size_t)levels->part_count;
    levels->shapes = mem_alloc(count, sizeof *levels->shapes);
    for (size_t i = 0; i < count; i++)
        levels->shapes[i].primitive = work->primitives[i];
    qsort(levels->shapes, count, sizeof *levels->shapes, compare_shapes);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || levels->shapes[i].primitive != levels->shapes[i - 1].primitive)
            levels->shapes[levels->shape_count++].primitive = levels->shapes[i].primitive;
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

static int compare_parts(const void *a, const void *b) {
    uint32_t x = ((const struct level_part *)a)->first_index;
    uint32_t y = ((const struct level_part *)b)->first_index;
    return (x > y) - (x < y);
}

static void list_parts(struct work *work) {
    const struct geometry *geometry = work->geometry;
    struct levels *levels = work->levels;
    size_t most = (size_t)geometry->part_count;
    levels->parts = mem_alloc(most, sizeof *levels->parts);
    work->primitives = mem_alloc(most, sizeof *work->primitives);
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        if (has_levels(work, part))
            levels->parts[levels->part_count++] = (struct level_part){
                .part = i, .first_index = part->first_index, .index_count = part->index_count};
    }
    qsort(levels->parts, (size_t)levels->part_count, sizeof *levels->parts, compare_parts);
    for (int i = 0; i < levels->part_count; i++)
        work->primitives[i] =
            geometry_primitive(work->scene, &geometry->parts[levels->parts[i].part]);
}

/* Adds its triangles by level. */
static void add_part(const struct work *work, struct level_part *part) {
    const struct geometry_part *own = &work->geometry->parts[part->part];
    const struct level_shape *shape =
        find_shape(work->levels, geometry_primitive(work->scene, own));
    const uint32_t *from = work->geometry->indices + part->first_index;
    float scale = simplify_scale(work->geometry->pose.worlds[own->node]) * shape->diagonal;
    struct levels *levels = work->levels;
    for (int l = 0; l < LEVEL_COUNT; l++) {
        part->error[l] = shape->has[l] ? level_errors[l] * scale : INFINITY;
        if (!shape->has[l])
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
    list_parts(&work);
    list_shapes(&work);
    parallel_for((size_t)levels->shape_count, 0, make_shape, levels);
    /* Pages that no triangle fills take no memory. */
    levels->indices =
        mem_alloc((size_t)geometry->index_count * LEVEL_COUNT, sizeof *levels->indices);
    for (int i = 0; i < levels->part_count; i++)
        add_part(&work, &levels->parts[i]);
    levels_measure(levels, geometry);
    for (int i = 0; i < levels->shape_count; i++)
        keep_coarsest(&levels->shapes[i]);
    free(work.primitives);
}

void levels_measure(struct levels *levels, const struct geometry *geometry) {
    for (int i = 0; i < levels->part_count; i++) {
        struct level_part *part = &levels->parts[i];
        const struct geometry_part *own = &geometry->parts[part->part];
        memcpy(part->box[0], own->bounds_min, sizeof own->bounds_min);
        memcpy(part->box[1], own->bounds_max, sizeof own->bounds_max);
    }
}

void levels_free_indices(struct levels *levels) {
    free(levels->indices);
    levels->indices = NULL;
}

void levels_free(struct levels *levels) {
    levels_free_indices(levels);
    for (int i = 0; i < levels->shape_count; i++)
        for (int l = 0; l < LEVEL_COUNT; l++)
            free(levels->shapes[i].moved[l]);
    mem_free(levels->shapes, levels->parts);
    *levels = (struct levels){0};
}

const uint32_t *levels_moved(const struct levels *levels, const struct primitive *primitive,
                             float error) {
    const struct level_shape *shape = find_shape(levels, primitive);
    bool fits = shape && level_errors[LEVEL_COUNT - 1] * shape->diagonal <= error;
    return fits ? shape->moved[LEVEL_COUNT - 1] : NULL;
}
