#include "shapes/decimate.h"

#include "base/memory.h"
#include "scene/mesh/simplify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Takes out the vertices that have moved; the others' new numbers. */
static uint32_t *drop_vertices(struct surface *surface, const uint32_t *moved_to) {
    uint32_t *renamed = mem_alloc(surface->vertex_count, sizeof *renamed), count = 0;
    for (uint32_t v = 0; v < surface->vertex_count; v++)
        if (moved_to[v] == v) {
            memmove(surface->position[count], surface->position[v], sizeof *surface->position);
            memmove(surface->normal[count], surface->normal[v], sizeof *surface->normal);
            renamed[v] = count++;
        }
    surface->vertex_count = count;
    return renamed;
}

void decimate(struct surface *surface, uint32_t triangle_count) {
    uint32_t *moved_to = mem_alloc(surface->vertex_count, sizeof *moved_to);
    simplify_mesh(&(struct simplify_mesh){.position = surface->position,
                                          .indices = surface->indices,
                                          .vertex_count = surface->vertex_count,
                                          .index_count = surface->index_count},
                  &(struct simplify_desc){.error = INFINITY, .triangle_count = triangle_count},
                  moved_to);
    uint32_t *renamed = drop_vertices(surface, moved_to), corners = 0;
    for (uint32_t k = 0; k < surface->index_count; k += 3) {
        const uint32_t *corner = surface->indices + k;
        uint32_t a = moved_to[corner[0]], b = moved_to[corner[1]], c = moved_to[corner[2]];
        if (a == b || b == c || c == a)
            continue;
        surface->indices[corners++] = renamed[a];
        surface->indices[corners++] = renamed[b];
        surface->indices[corners++] = renamed[c];
    }
    surface->index_count = corners;
    free(moved_to);
    free(renamed);
}
