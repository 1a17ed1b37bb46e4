#include "scene/mesh/edge_table.h"

#include "base/memory.h"

#include <assert.h>
#include <stdlib.h>

/* Where the key is or would be. */
static size_t slot_of(const struct edge_table *table, uint64_t key) {
    /* Fibonacci hashing: the upper bits of the product with 2^64 over the golden ratio. */
    size_t slot = (size_t)(key * 0x9E3779B97F4A7C15u >> 24) & (table->capacity - 1);
    while (table->keys[slot] && table->keys[slot] != key)
        slot = (slot + 1) & (table->capacity - 1);
    return slot;
}

static void grow(struct edge_table *table) {
    struct edge_table old = *table;
    table->capacity = old.capacity ? old.capacity * 2 : 1024;
    table->keys = mem_alloc(table->capacity, sizeof *table->keys);
    table->values = mem_alloc(table->capacity, sizeof *table->values);
    for (size_t i = 0; i < old.capacity; i++) {
        if (!old.keys[i])
            continue;
        size_t slot = slot_of(table, old.keys[i]);
        table->keys[slot] = old.keys[i];
        table->values[slot] = old.values[i];
    }
    free(old.keys);
    free(old.values);
}

uint32_t *edge_table_at(struct edge_table *table, uint32_t a, uint32_t b) {
    assert(a != b);
    if (table->count * 2 >= table->capacity)
        grow(table);
    uint64_t key = a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
    size_t slot = slot_of(table, key);
    if (!table->keys[slot]) {
        table->keys[slot] = key;
        table->count++;
    }
    return &table->values[slot];
}

void edge_table_free(struct edge_table *table) {
    free(table->keys);
    free(table->values);
    *table = (struct edge_table){0};
}
