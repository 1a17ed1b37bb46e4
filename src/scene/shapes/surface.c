#include "scene/shapes/surface.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

void surface_free(struct surface *surface) {
    mem_free(surface->position, surface->normal, surface->indices);
    *surface = (struct surface){0};
}

void surface_clear(struct surface *surface) {
    surface->vertex_count = surface->index_count = 0;
}

static uint32_t grown(uint32_t capacity) {
    return capacity ? 2 * capacity : 1024;
}

uint32_t surface_add_vertex(struct surface *surface, const float position[3],
                            const float normal[3]) {
    if (surface->vertex_count == surface->vertex_capacity) {
        surface->vertex_capacity = grown(surface->vertex_capacity);
        surface->position =
            mem_resize(surface->position, surface->vertex_capacity, sizeof *surface->position);
        surface->normal =
            mem_resize(surface->normal, surface->vertex_capacity, sizeof *surface->normal);
    }
    uint32_t index = surface->vertex_count++;
    memcpy(surface->position[index], position, sizeof surface->position[index]);
    memcpy(surface->normal[index], normal, sizeof surface->normal[index]);
    return index;
}

void surface_add_triangle(struct surface *surface, uint32_t a, uint32_t b, uint32_t c) {
    if (surface->index_count + 3 > surface->index_capacity) {
        surface->index_capacity = grown(surface->index_capacity);
        surface->indices =
            mem_resize(surface->indices, surface->index_capacity, sizeof *surface->indices);
    }
    uint32_t *triangle = surface->indices + surface->index_count;
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    surface->index_count += 3;
}
