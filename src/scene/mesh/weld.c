#include "scene/mesh/weld.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

/* Open addressing; each slot has the vertex that came first, plus one. */
struct table {
    float (*position)[3];
    uint32_t *slots, mask;
};

static void table_init(struct table *table, float (*position)[3], uint32_t count) {
    uint32_t size = 16;
    while (size < 2 * count)
        size *= 2;
    *table = (struct table){position, mem_alloc(size, sizeof *table->slots), size - 1};
}

static uint32_t hash(const float position[3]) {
    uint32_t h = 0;
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

/* The first vertex at the place of this one, which may be itself. */
static uint32_t first_alike(struct table *table, uint32_t vertex) {
    const float *position = table->position[vertex];
    uint32_t i = hash(position) & table->mask;
    for (; table->slots[i]; i = (i + 1) & table->mask)
        if (same_place(table->position[table->slots[i] - 1], position))
            return table->slots[i] - 1;
    table->slots[i] = vertex + 1;
    return vertex;
}

void weld_vertices(float (*position)[3], uint32_t count, uint32_t *first) {
    struct table table;
    table_init(&table, position, count);
    for (uint32_t v = 0; v < count; v++)
        first[v] = first_alike(&table, v);
    free(table.slots);
}

bool *weld_find_shared(const struct geometry *geometry) {
    bool *shared = mem_alloc(geometry->vertex_count, sizeof *shared);
    struct table table;
    table_init(&table, geometry->position, geometry->vertex_count);
    for (int p = 0; p < geometry->part_count; p++) {
        const struct geometry_part *part = &geometry->parts[p];
        for (uint32_t i = 0; i < part->vertex_count; i++) {
            uint32_t vertex = part->first_vertex + i, other = first_alike(&table, vertex);
            if (other < part->first_vertex)
                shared[other] = shared[vertex] = true;
        }
    }
    free(table.slots);
    return shared;
}
