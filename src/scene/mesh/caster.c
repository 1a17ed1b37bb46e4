#include "scene/mesh/caster.h"

#include "base/memory.h"
#include "scene/mesh/corners.h"
#include "scene/mesh/simplify.h"
#include "scene/mesh/solid.h"

#include <assert.h>
#include <cglm/cglm.h>
#include <stdlib.h>
#include <string.h>

/* --- scale ------------------------------------------------------------------------------------ */

/* No triangle counts for more than this part of all surfaces. */
enum { LARGEST_PART = 10 };

/* Largest first. */
static void keep_largest(double largest[LARGEST_PART], double area) {
    for (int i = 0; i < LARGEST_PART; i++)
        if (area > largest[i]) {
            double smaller = largest[i];
            largest[i] = area;
            area = smaller;
        }
}

/* The root of the area of all that keeps its shape. A plain of a few triangles around a room is
 * hardly a part of it: where m triangles are too large, the rest is all but m parts. */
static float surface_size(const struct geometry *geometry) {
    double rest = 0, largest[LARGEST_PART] = {0};
    for (int p = 0; p < geometry->part_count; p++) {
        const struct geometry_part *part = &geometry->parts[p];
        for (uint32_t k = 0; k < part->index_count && part->rigid; k += 3) {
            double area = corners_area(geometry, geometry->indices + part->first_index + k);
            keep_largest(largest, area);
            rest += area;
        }
    }
    for (int m = 0; m < LARGEST_PART; m++) {
        double all = rest * LARGEST_PART / (LARGEST_PART - m);
        if (largest[m] * LARGEST_PART <= all)
            return (float)sqrt(all);
        rest -= largest[m];
    }
    return 0;
}

/* --- what is long ----------------------------------------------------------------------------- */

/* The same bits for triangles that share the edge. */
static float longest_edge(const struct geometry *geometry, const uint32_t corner[3]) {
    float longest = 0;
    for (int e = 0; e < 3; e++)
        longest = fmaxf(longest, glm_vec3_distance2(geometry->position[corner[e]],
                                                    geometry->position[corner[(e + 1) % 3]]));
    return sqrtf(longest);
}

static int compare_falling(const void *a, const void *b) {
    float x = *(const float *)a, y = *(const float *)b;
    return (x < y) - (x > y);
}

/* The length that no more than so many triangles surpass: those of a grid are alike, and all short
 * where they are too many. */
static float find_long_edge(const struct caster_list *all, const struct geometry *geometry,
                            uint32_t long_count) {
    float *edges = mem_alloc(all->index_count / 3, sizeof *edges);
    uint32_t count = 0;
    for (int i = 0; i < geometry->blocking_batch_count; i++) {
        const struct geometry_batch *batch = &all->batches[i];
        for (uint32_t k = 0; k < batch->index_count && !batch->dynamic; k += 3)
            edges[count++] = longest_edge(geometry, all->indices + batch->first_index + k);
    }
    qsort(edges, count, sizeof *edges, compare_falling);
    float found = count > long_count ? edges[long_count] : 0;
    free(edges);
    return found;
}

/* --- lists ------------------------------------------------------------------------------------ */

static void list_init(struct caster_list *list, const struct geometry *geometry,
                      uint32_t index_count) {
    *list = (struct caster_list){
        .indices = mem_alloc(index_count, sizeof *list->indices),
        .batches = mem_alloc((size_t)geometry->batch_count, sizeof *list->batches),
    };
}

static void list_free(struct caster_list *list) {
    mem_free(list->indices, list->batches);
}

static void list_begin_batch(struct caster_list *list, const struct geometry *geometry, int batch) {
    list->batches[batch] = geometry->batches[batch];
    list->batches[batch].first_index = list->index_count;
    list->batches[batch].index_count = 0;
}

static void list_add(struct caster_list *list, const uint32_t *indices, uint32_t count) {
    memcpy(list->indices + list->index_count, indices, count * sizeof *indices);
    list->index_count += count;
}

static void list_end_batch(struct caster_list *list, const struct geometry *geometry, int batch) {
    struct geometry_batch *made = &list->batches[batch];
    made->index_count = list->index_count - made->first_index;
    if (geometry->batches[batch].first_index < geometry->opaque_index_count)
        list->opaque_index_count = list->index_count;
}

/* Without the triangles of which moving the vertices leaves nothing. */
static void add_moved(struct caster_list *list, const struct geometry *geometry,
                      const struct geometry_batch *batch, const uint32_t *moved_to) {
    for (uint32_t k = 0; k < batch->index_count; k += 3) {
        const uint32_t *corner = geometry->indices + batch->first_index + k;
        uint32_t moved[3] = {moved_to[corner[0]], moved_to[corner[1]], moved_to[corner[2]]};
        if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0])
            list_add(list, moved, 3);
    }
}

static void list_all(struct caster_list *list, const struct geometry *geometry,
                     const uint32_t *moved_to) {
    list_init(list, geometry, geometry->index_count);
    for (int i = 0; i < geometry->blocking_batch_count; i++) {
        const struct geometry_batch *batch = &geometry->batches[i];
        list_begin_batch(list, geometry, i);
        if (moved_to && !batch->dynamic)
            add_moved(list, geometry, batch, moved_to);
        else
            list_add(list, geometry->indices + batch->first_index, batch->index_count);
        list_end_batch(list, geometry, i);
    }
}

/* --- the caster ------------------------------------------------------------------------------- */

static enum caster_kind kind_of(bool is_long, bool is_solid) {
    if (is_solid)
        return is_long ? CASTER_LONG_SOLID : CASTER_SHORT_SOLID;
    return is_long ? CASTER_LONG : CASTER_SHORT;
}

/* is_solid: of each triangle. */
static void sort_out(struct caster *caster, const struct caster_list *all,
                     const struct geometry *geometry, const bool *is_solid) {
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        list_init(&caster->list[l], geometry, all->index_count);
    for (int i = 0; i < geometry->blocking_batch_count; i++) {
        const struct geometry_batch *batch = &all->batches[i];
        for (int l = 0; l < CASTER_KIND_COUNT; l++)
            list_begin_batch(&caster->list[l], geometry, i);
        for (uint32_t k = 0; k < batch->index_count; k += 3) {
            uint32_t first = batch->first_index + k;
            const uint32_t *corner = all->indices + first;
            bool is_long = !batch->dynamic && longest_edge(geometry, corner) > caster->long_edge;
            list_add(&caster->list[kind_of(is_long, is_solid[first / 3])], corner, 3);
        }
        for (int l = 0; l < CASTER_KIND_COUNT; l++)
            list_end_batch(&caster->list[l], geometry, i);
    }
}

/* Metaballs close, whatever their pose; but near a map's centre fronts are left out, and of exact
 * casters backs are all that blocks. */
static enum caster_kind kind_of_dynamic(const struct caster *caster,
                                        const struct geometry *geometry, int batch) {
    bool opaque = geometry->batches[batch].first_index < geometry->opaque_index_count;
    return kind_of(false, opaque && caster->error > 0);
}

/* Masked triangles hide no back. */
static bool *find_solid(const struct caster *caster, const struct caster_list *all,
                        const struct geometry *geometry, const float *eye) {
    bool *is_solid = mem_alloc(all->index_count / 3, sizeof *is_solid);
    struct solid_mesh opaque = {geometry->position, all->indices, all->opaque_index_count / 3,
                                geometry_clearance(geometry)};
    if (eye)
        solid_find(is_solid, &opaque, eye);
    for (int i = 0; i < geometry->blocking_batch_count; i++) {
        const struct geometry_batch *batch = &all->batches[i];
        if (batch->dynamic && kind_of_dynamic(caster, geometry, i) == CASTER_SHORT_SOLID)
            memset(is_solid + batch->first_index / 3, true, batch->index_count / 3);
    }
    return is_solid;
}

void caster_init(struct caster *caster, const struct geometry *geometry,
                 const struct caster_desc *desc) {
    *caster = (struct caster){
        .vertex_count = geometry->vertex_count,
        .batch_count = geometry->blocking_batch_count,
        .error = desc->error * surface_size(geometry),
    };
    uint32_t *moved_to =
        desc->error > 0
            ? simplify_geometry(geometry, &(struct simplify_desc){.error = caster->error,
                                                                  .scene = desc->scene,
                                                                  .levels = desc->levels})
            : NULL;
    struct caster_list all;
    list_all(&all, geometry, moved_to);
    caster->long_edge = find_long_edge(&all, geometry, (uint32_t)desc->long_count);
    bool *is_solid = find_solid(caster, &all, geometry, desc->eye);
    sort_out(caster, &all, geometry, is_solid);
    free(is_solid);
    list_free(&all);
    free(moved_to);
}

void caster_free(struct caster *caster) {
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        list_free(&caster->list[l]);
    *caster = (struct caster){0};
}

enum caster_kind caster_take_batch(struct caster *caster, const struct geometry *geometry,
                                   int batch) {
    enum caster_kind kind = kind_of_dynamic(caster, geometry, batch);
    struct caster_list *list = &caster->list[kind];
    const struct geometry_batch *from = &geometry->batches[batch], *to = &list->batches[batch];
    assert(from->dynamic && from->index_count == to->index_count);
    memcpy(list->indices + to->first_index, geometry->indices + from->first_index,
           from->index_count * sizeof *list->indices);
    return kind;
}

/* Static vertices keep their numbers. */
static void lay_out(struct caster *caster, const struct geometry *geometry, enum caster_kind kind) {
    struct caster_list *list = &caster->list[kind], old = *list;
    list_init(list, geometry, old.index_count + geometry->index_count);
    for (int i = 0; i < caster->batch_count; i++) {
        const struct geometry_batch *now = &geometry->batches[i], *batch = &old.batches[i];
        list_begin_batch(list, geometry, i);
        if (!now->dynamic)
            list_add(list, old.indices + batch->first_index, batch->index_count);
        else if (kind == kind_of_dynamic(caster, geometry, i))
            list_add(list, geometry->indices + now->first_index, now->index_count);
        list_end_batch(list, geometry, i);
    }
    list_free(&old);
}

void caster_lay_out(struct caster *caster, const struct geometry *geometry) {
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        lay_out(caster, geometry, (enum caster_kind)l);
    caster->vertex_count = geometry->vertex_count;
}
