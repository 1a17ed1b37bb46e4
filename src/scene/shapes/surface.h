/* A growable surface of triangles, written by marching cubes and the scene tool.
 *
 * Triangles are counter-clockwise seen from their normals' side. Clearing keeps the memory, so
 * surfaces that are rebuilt each frame stop allocating. */
#ifndef SCENE_SHAPES_SURFACE_H
#define SCENE_SHAPES_SURFACE_H

#include <stdint.h>

struct surface {
    float (*position)[3];
    float (*normal)[3]; /* unit */
    uint32_t *indices;  /* 3 a triangle */
    uint32_t vertex_count, index_count;
    uint32_t vertex_capacity, index_capacity;
};

/* Removes all triangles. Accepts zeroed surfaces, as do all functions here. */
void surface_free(struct surface *surface);
void surface_clear(struct surface *surface);

/* Returns the vertex's index. */
uint32_t surface_add_vertex(struct surface *surface, const float position[3],
                            const float normal[3]);
void surface_add_triangle(struct surface *surface, uint32_t a, uint32_t b, uint32_t c);

#endif
