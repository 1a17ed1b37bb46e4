/* Fewer triangles for nearly the same surface, by collapsing edges [Garland and Heckbert 1997,
 * Surface Simplification Using Quadric Error Metrics]: shadow casters, and made scenes.
 *
 * A map of 256 x 256 texels cannot show the folds of a drape, but would transform their triangles
 * for each of its layers. A vertex is moved onto one of its neighbours where that lies near the
 * planes of all the triangles that the vertex stands for; it stays among the geometry's vertices,
 * so that what moves needs nothing anew. The cheapest collapses come first, in passes of such as do
 * not touch. A surface falls back behind the finer one rather than before it, where receivers would
 * lie in its shadow. What is closed stays closed, and no triangle turns over in a step.
 *
 * meshoptimizer knows no side: with as many triangles a horse's caster came forward by three times
 * as much. It also locks all borders or none, and leaves twice the triangles of Sponza.
 */
#ifndef SCENE_MESH_SIMPLIFY_H
#define SCENE_MESH_SIMPLIFY_H

#include "scene/mesh/geometry.h"

struct simplify_desc {
    float error; /* how far surfaces may stray, root mean square; INFINITY = as they do */
    uint32_t triangle_count; /* no fewer triangles are left */
};

/* Triangles that share the vertices in which they meet. */
struct simplify_mesh {
    float (*position)[3];
    const uint32_t *indices; /* 3 per triangle */
    const bool *locked;      /* vertices that stay; NULL = none */
    uint32_t vertex_count, index_count;
};

/* For each vertex the one that it is moved onto, which may be itself. */
void simplify_mesh(const struct simplify_mesh *mesh, const struct simplify_desc *desc,
                   uint32_t *moved_to);

/* The same for all parts of a geometry, small ones with less of an error; to be freed. Parts with an
 * alpha mask keep their triangles, and so do those that do not move rigidly. A vertex that parts
 * share stays, so that no crack opens between them. */
uint32_t *simplify_geometry(const struct geometry *geometry, const struct simplify_desc *desc);

#endif
