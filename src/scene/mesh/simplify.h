/* Coarser shadow casters, by collapsing edges [Garland and Heckbert 1997, Surface Simplification
 * Using Quadric Error Metrics].
 *
 * A map of 256 x 256 texels cannot show the folds of a drape, but would transform their triangles
 * for each of its layers. A vertex is moved onto one of its neighbours where that lies near the
 * planes of all the triangles that the vertex stands for; it stays among the geometry's vertices,
 * so that what moves needs nothing anew. The cheapest collapses come first, in passes of such as do
 * not touch. A surface falls back behind the finer one rather than before it, where receivers would
 * lie in its shadow.
 *
 * What is closed stays closed, and no triangle turns over in a step. A vertex that parts share
 * stays, so that no crack opens between them. Parts with an alpha mask keep their triangles, and so
 * do those that do not move rigidly.
 */
#ifndef SCENE_MESH_SIMPLIFY_H
#define SCENE_MESH_SIMPLIFY_H

#include "scene/mesh/geometry.h"

struct simplify_desc {
    float error;    /* how far surfaces may stray, root mean square, metres; less in small parts */
    float max_edge; /* no longer edges are made, metres */
};

/* For each vertex the one of its part that it is moved onto, which may be itself; to be freed. */
uint32_t *simplify_vertices(const struct geometry *geometry, const struct simplify_desc *desc);

#endif
