/* The surface of an implicit function as triangles, by marching cubes.
 *
 * [Lorensen and Cline 1987], with the table of cases generated rather than typed in: each face of a
 * cell joins its crossed edges by a rule that looks at that face alone, and so neighbours agree and
 * the surface closes. Where a face is ambiguous the inside corners are kept apart.
 *
 * The grid is swept slice by slice and only two slices are held. A vertex lies on an edge of the
 * grid and is shared by all triangles around it.
 */
#ifndef SCENE_SHAPES_MARCHING_CUBES_H
#define SCENE_SHAPES_MARCHING_CUBES_H

#include "scene/shapes/surface.h"

#include <stdbool.h>
#include <stddef.h>

/* A function of space, positive inside. Rows, because a field of many parts can skip most of them
 * for a whole row. */
struct implicit {
    const void *context;
    /* Its values at `count` points, the first one given, the others each `step` further in x. */
    void (*row)(const void *context, const float first[3], float step, int count, float *values);
    /* Its gradient at a point of the surface: points inwards, any length but 0. */
    void (*gradient)(const void *context, const float point[3], float gradient[3]);
};

/* Cubes of side `step`. The surface should lie within: where it leaves the grid it stays open. */
struct marching_grid {
    float low[3], step;
    int cells[3];
};

enum { MARCHING_CASES = 256, MARCHING_CASE_SIZE = 16 };

/* The table and the memory of the two slices, kept from call to call. */
struct marching_cubes {
    /* Of each pattern of inside corners, triangles: three edges each, ended by 0xFF. */
    uint8_t cases[MARCHING_CASES][MARCHING_CASE_SIZE];
    /* Of the slice and the one before: values at the points, and the vertices on the three edges
     * that go from each point in +x, +y and +z. */
    float *values[2];
    uint32_t (*vertices[2])[3];
    size_t capacity;
    bool *wrong; /* of each vertex: its normal does not fit its triangles */
    size_t wrong_capacity;
};

void marching_cubes_init(struct marching_cubes *cubes);
void marching_cubes_free(struct marching_cubes *cubes);

/* Adds the triangles to the surface; normals are
 * unit and point outwards. */
void marching_cubes_polygonise(struct marching_cubes *cubes, const struct implicit *implicit,
                               const struct marching_grid *grid, struct surface *surface);

#endif
