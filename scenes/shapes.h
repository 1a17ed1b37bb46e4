/* Simple shapes added to a surface. Normals point outwards unless said otherwise. */
#ifndef SCENES_SHAPES_H
#define SCENES_SHAPES_H

#include "scene/surface.h"

/* Two triangles with a flat normal, counter-clockwise a b c d. */
void add_quad(struct surface *surface, const float a[3], const float b[3], const float c[3],
              const float d[3]);

/* A closed prism: four corners of the top, counter-clockwise seen from above, down to height low.
 */
void add_block(struct surface *surface, const float top[4][3], float low);

/* A sphere of radius 1 about the origin, seen from inside: normals point to the centre and are
 * exact. 12 n^2 triangles of nearly equal size. */
void add_sphere_inside(struct surface *surface, int n);

/* Sets all normals to the mean of the triangles around, weighted by their angles at the vertex
 * [Thuermer and Wuethrich 1998]. */
void smooth_normals(struct surface *surface);

#endif
