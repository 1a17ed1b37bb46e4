#include "scene/weld.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct cell {
    int32_t at[3], part;
};

/* A small thing in a large scene keeps its shape: cells are at most so large, over its diagonal. */
static const float part_fraction = 0.01f;

/* Open addressing; each slot has the vertex that came first, plus one. */
struct grid {
    const struct geometry *geometry;
    float size; /* of the present part's cells */
    uint32_t *slots, mask;
};

static float diagonal(const struct geometry_part *part) {
    float sum = 0;
    for (int c = 0; c < 3; c++) {
        float side = part->bounds_max[c] - part->bounds_min[c];
        sum += side * side;
    }
    return sqrtf(sum);
}

static struct cell cell_of(const struct grid *grid, uint32_t vertex, int part) {
    struct cell cell = {.part = part};
    for (int c = 0; c < 3; c++)
        cell.at[c] = (int32_t)floorf(
            (grid->geometry->position[vertex][c] - grid->geometry->bounds_min[c]) / grid->size);
    return cell;
}

static uint32_t hash(const struct cell *cell) {
    uint32_t h = (uint32_t)cell->part * 2654435761U;
    for (int c = 0; c < 3; c++)
        h = (h ^ (uint32_t)cell->at[c]) * 2246822519U;
    return h ^ h >> 15;
}

static uint32_t first_in_cell(struct grid *grid, uint32_t vertex, int part) {
    struct cell cell = cell_of(grid, vertex, part);
    uint32_t i = hash(&cell) & grid->mask;
    for (; grid->slots[i]; i = (i + 1) & grid->mask) {
        uint32_t first = grid->slots[i] - 1;
        struct cell other = cell_of(grid, first, part);
        /* Parts lie one after another, so that an earlier part's vertex is below the first of this.
         */
        bool same_part = first >= grid->geometry->parts[part].first_vertex;
        if (same_part && memcmp(&cell, &other, sizeof cell) == 0)
            return first;
    }
    grid->slots[i] = vertex + 1;
    return vertex;
}

uint32_t *weld_vertices(const struct geometry *geometry, float cell) {
    uint32_t *first = mem_alloc(geometry->vertex_count, sizeof *first), size = 16;
    while (size < 2 * geometry->vertex_count)
        size *= 2;
    struct grid grid = {geometry, 0, mem_alloc(size, sizeof(uint32_t)), size - 1};
    for (uint32_t i = 0; i < geometry->vertex_count; i++)
        first[i] = i;
    for (int part = 0; part < geometry->part_count; part++) {
        const struct geometry_part *range = &geometry->parts[part];
        grid.size = fminf(cell, part_fraction * diagonal(range));
        for (uint32_t i = 0; i < range->vertex_count; i++)
            first[range->first_vertex + i] = first_in_cell(&grid, range->first_vertex + i, part);
    }
    free(grid.slots);
    return first;
}
