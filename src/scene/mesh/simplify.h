/* Simplifies meshes by edge collapses [Garland and Heckbert 1997, Surface Simplification Using
 * Quadric Error Metrics], for shadow casters and generated scenes.
 *
 * A small map does not show folds of a drape, but would transform their triangles for each layer. A
 * vertex collapses onto a neighbour near the planes of all triangles that it represents, so
 * vertices remain the geometry's and move with it. The cheapest collapses come first, in passes of
 * collapses that do not touch. Surfaces recede rather than advance, which would shadow receivers.
 * Closed meshes stay closed, and no triangle flips. meshoptimizer has no preferred side: at equal
 * triangle counts a caster advanced three times as far. It locks all borders or none. */
#ifndef SCENE_MESH_SIMPLIFY_H
#define SCENE_MESH_SIMPLIFY_H

#include "scene/mesh/geometry.h"

struct simplify_desc {
    float error;             /* surface error, root mean square; INFINITY: unbounded */
    uint32_t triangle_count; /* least number of triangles left */
    bool holds_borders;      /* vertices of borders stay */
    /* For simplify_mesh: each vertex's error; a negative one holds it. NULL: all have `error`. */
    const float *errors;
    /* For simplify_geometry: the scene whose instances share their triangles; NULL: none do. */
    const struct scene *scene;
    const struct levels *levels; /* of the scene, to begin with (scene/mesh/levels.h); or NULL */
};

/* Triangles with shared vertices. */
struct simplify_mesh {
    float (*position)[3];
    const uint32_t *indices; /* 3 a triangle */
    const bool *locked;      /* fixed vertices; NULL: none */
    uint32_t vertex_count, index_count;
    float (*normal)[3]; /* a vertex collapses only onto one of nearly its normal; NULL: onto any */
};

/* Returns the longest image of the axes' unit vectors under a world matrix. */
float simplify_scale(const float world[16]);

/* Writes for each vertex the one it collapses onto, perhaps itself. */
void simplify_mesh(const struct simplify_mesh *mesh, const struct simplify_desc *desc,
                   uint32_t *moved_to);

/* Simplifies all parts of a geometry, small ones with a smaller error, as simplify_mesh. A mesh is
 * simplified once for its instances of one size. The caller frees the result. Masked and non-rigid
 * parts keep their triangles. Vertices shared by parts stay, so that no crack opens. */
uint32_t *simplify_geometry(const struct geometry *geometry, const struct simplify_desc *desc);

#endif
