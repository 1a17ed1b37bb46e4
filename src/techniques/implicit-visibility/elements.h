/* Surface elements: disks that stand for a scene's surfaces in radiosity [Dong 2011 §4.3.1].
 *
 * The thesis makes one of each vertex, with a third of its triangles' area. Here triangles with edges longer than a bound
 * are cut first, and vertices within one cell of a grid that face alike are one element. So coarse walls and fine models
 * both have elements about as far apart. The areas' sum is the surface's. An element keeps its place in its triangle
 * and its area when the triangle moves. Materials of two sides have elements on both. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_ELEMENTS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_ELEMENTS_H

#include "scene/material.h"
#include "scene/mesh/geometry.h"

struct element {
    uint32_t corners[3]; /* vertices of its triangle */
    float weights[3];    /* of the corners */
    float side;          /* 1; -1: the triangle's back */
    bool pane;           /* it receives light, and is too small to hide or send any */
    float area;          /* m2 */
    vec3s albedo;
    vec3s emission;         /* W/(sr m2) */
    vec3s position, normal; /* elements_place */
};

struct elements {
    struct element *items;
    int count;
    float
        edge; /* the longest of a cut triangle: no place of a surface is farther from an element, m */
};

struct elements_desc {
    const struct scene *scene;
    const struct geometry *geometry;
    enum materials materials;
    bool smooth_black; /* glass and mirrors reflect nothing: caustics carry their light */
    int most;          /* elements */
    bool panes;        /* have elements, too */
};

/* At most desc->most, unless more cells of the coarsest grid are occupied. Zero elements where no triangle has an area. */
void elements_init(struct elements *elements, const struct elements_desc *desc);
void elements_free(struct elements *elements);

/* Moves them to where the geometry is. Its arrays lie as they did at elements_init. */
void elements_place(struct elements *elements, const struct geometry *geometry);

#endif
