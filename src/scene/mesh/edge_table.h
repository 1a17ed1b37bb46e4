/* A number for each edge between two vertices: a hash table with linear probing. */
#ifndef SCENE_MESH_EDGE_TABLE_H
#define SCENE_MESH_EDGE_TABLE_H

#include <stddef.h>
#include <stdint.h>

struct edge_table {
    uint64_t *keys; /* the two ends; 0 = free, for no edge joins vertex 0 with itself */
    uint32_t *values;
    size_t capacity, count; /* capacity is a power of two or 0 */
};

/* The edge's value, whichever end is named first; 0 when the edge is new. The pointer is good until
 * the next call. a and b differ. */
uint32_t *edge_table_at(struct edge_table *table, uint32_t a, uint32_t b);

/* Accepts zeroed tables, as edge_table_at does. */
void edge_table_free(struct edge_table *table);

#endif
