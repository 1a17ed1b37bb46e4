#include "scene/mesh/weld.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { ANY_PART = -1 };

/* Open addressing; each slot has the vertex that came first, plus one. */
struct table {
    const struct geometry *geometry;
    uint32_t *slots, mask;
};

static void table_init(struct table *table, const struct geometry *geometry) {
    uint32_t size = 16;
    while (size < 2 * geometry->vertex_count)
        size *= 2;
    *table = (struct table){geometry, mem_alloc(size, sizeof *table->slots), size - 1};
}

static uint32_t hash(const float position[3], int part) {
    uint32_t h = (uint32_t)part * 2654435761U;
    for (int c = 0; c < 3; c++) {
        float coordinate = position[c] + 0; /* -0 is 0 */
        uint32_t bits;
        memcpy(&bits, &coordinate, sizeof bits);
        h = (h ^ bits) * 2246822519U;
        h ^= h >> 15;
    }
    return h;
}

static bool same_place(const float a[3], const float b[3]) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* The first vertex of the part, or of any, at the place of this one, which may be itself. Parts are
 * asked for one after another, as they lie: an earlier part's vertices are below this one's. */
static uint32_t first_alike(struct table *table, uint32_t vertex, int part) {
    const struct geometry *geometry = table->geometry;
    const float *position = geometry->position[vertex];
    uint32_t least = part == ANY_PART ? 0 : geometry->parts[part].first_vertex;
    uint32_t i = hash(position, part) & table->mask;
    for (; table->slots[i]; i = (i + 1) & table->mask) {
        uint32_t first = table->slots[i] - 1;
        if (first >= least && same_place(geometry->position[first], position))
            return first;
    }
    table->slots[i] = vertex + 1;
    return vertex;
}

void weld_init(struct weld *weld, const struct geometry *geometry) {
    struct table own, all;
    table_init(&own, geometry);
    table_init(&all, geometry);
    *weld = (struct weld){mem_alloc(geometry->vertex_count, sizeof *weld->first),
                          mem_alloc(geometry->vertex_count, sizeof *weld->shared)};
    for (uint32_t i = 0; i < geometry->vertex_count; i++)
        weld->first[i] = i;
    for (int p = 0; p < geometry->part_count; p++) {
        const struct geometry_part *part = &geometry->parts[p];
        for (uint32_t i = 0; i < part->vertex_count; i++) {
            uint32_t vertex = part->first_vertex + i, other = first_alike(&all, vertex, ANY_PART);
            weld->first[vertex] = first_alike(&own, vertex, p);
            if (other < part->first_vertex)
                weld->shared[other] = weld->shared[weld->first[vertex]] = true;
        }
    }
    mem_free(own.slots, all.slots);
}

void weld_free(struct weld *weld) {
    mem_free(weld->first, weld->shared);
    *weld = (struct weld){0};
}
