/* Surface elements: disks that represent a scene's surfaces in radiosity [Dong 2011 §4.3.1].
 *
 * The thesis makes one element of each vertex, with a third of its triangles' area. Here triangles
 * with edges above a bound are cut first. Vertices in one grid cell with similar normals become one
 * element. So coarse walls and fine models have elements at similar distances. The areas sum to the
 * surface's. An element keeps its barycentric position and area when its triangle moves.
 * Double-sided materials have elements on both sides. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_ELEMENTS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_ELEMENTS_H

#include "scene/material.h"
#include "scene/mesh/geometry.h"

struct element {
    uint32_t corners[3]; /* vertices of its triangle */
    float weights[3];    /* barycentric weights of the corners */
    float side;          /* 1: front; -1: back of the triangle */
    bool pane;           /* receives light; too small to block or to send any */
    float area;          /* m2 */
    vec3s albedo;
    vec3s emission;         /* W/(sr m2) */
    vec3s position, normal; /* set by elements_place */
};

struct elements {
    struct element *items;
    int count;
    /* Longest edge of a cut triangle, metres: a bound on the distance from a surface point to an
     * element. */
    float edge;
};

struct elements_desc {
    const struct scene *scene;
    const struct geometry *geometry;
    enum materials materials;
    bool smooth_black; /* glass and mirrors have albedo 0, because caustics carry their light */
    int most;          /* most elements */
    bool panes;        /* makes elements on panes, too */
};

/* Makes at most desc->most elements, unless the coarsest grid has more occupied cells. Makes none
 * if no triangle has an area. */
void elements_init(struct elements *elements, const struct elements_desc *desc);
void elements_free(struct elements *elements);

/* Moves the elements to the geometry's pose. Its arrays must have the layout of elements_init. */
void elements_place(struct elements *elements, const struct geometry *geometry);

#endif
