/* Triangulates the surface of an implicit function by marching cubes [Lorensen and Cline 1987].
 *
 * The case table is generated. Each face of a cell joins its crossed edges by a rule of this face
 * alone, so neighbours agree and the surface closes. Ambiguous faces keep inside corners apart. The
 * grid is swept slice by slice with two slices in memory. Triangles share the vertices on grid
 * edges. */
#ifndef SCENE_SHAPES_MARCHING_CUBES_H
#define SCENE_SHAPES_MARCHING_CUBES_H

#include "scene/shapes/surface.h"

#include <stdbool.h>
#include <stddef.h>

/* A function of space, positive inside. It is evaluated in rows, because fields of many parts can
 * skip most of them for a whole row. */
struct implicit {
    const void *context;
    /* Writes values at `count` points: `first`, then steps of `step` in x. */
    void (*row)(const void *context, const float first[3], float step, int count, float *values);
    /* Writes the gradient at a surface point: it points inwards, with any length except 0. */
    void (*gradient)(const void *context, const float point[3], float gradient[3]);
};

/* Cubes of side `step`. A surface that leaves the grid stays open. */
struct marching_grid {
    float low[3], step;
    int cells[3];
};

enum { MARCHING_CASES = 256, MARCHING_CASE_SIZE = 16 };

/* Case table and slice memory, kept between calls. */
struct marching_cubes {
    /* Triangles of each pattern of inside corners: three edges each, ended by 0xFF. */
    uint8_t cases[MARCHING_CASES][MARCHING_CASE_SIZE];
    /* This slice and the previous one: values at the points, and vertices on the three edges from
     * each point in +x, +y and +z. */
    float *values[2];
    uint32_t (*vertices[2])[3];
    size_t capacity;
    bool *wrong; /* for each vertex: its normal contradicts its triangles */
    size_t wrong_capacity;
};

void marching_cubes_init(struct marching_cubes *cubes);
void marching_cubes_free(struct marching_cubes *cubes);

/* Appends the triangles to the surface. Normals are unit and point outwards. */
void marching_cubes_polygonise(struct marching_cubes *cubes, const struct implicit *implicit,
                               const struct marching_grid *grid, struct surface *surface);

#endif
