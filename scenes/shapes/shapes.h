/* Simple shapes added to a surface. Each is closed, with normals outwards, unless said otherwise */
#ifndef SCENES_SHAPES_H
#define SCENES_SHAPES_H

#include "scene/shapes/surface.h"

/* Two triangles with a flat normal, counter-clockwise a b c d. Open. */
void add_quad(struct surface *surface, const float a[3], const float b[3], const float c[3],
              const float d[3]);

/* A prism: four corners of the top, counter-clockwise seen from above, down to height low. */
void add_block(struct surface *surface, const float top[4][3], float low);

/* A box along the axes. */
void add_box(struct surface *surface, const float low[3], const float high[3]);

/* A sphere of radius 1 about the origin, seen from inside: normals point to the centre and are
 * exact. 12 n^2 triangles of nearly equal size. */
void add_sphere_inside(struct surface *surface, int n);

/* A body turned about the y axis. The profile runs from bottom to top and starts and ends on the
 * axis. `lobe` swells the radius by so much of it, as often round the circle as lobes says. Joints
 * of less than 35 degrees are shaded smooth. */
struct lathe_point {
    float radius, y, lobe;
};
void add_lathe(struct surface *surface, const struct lathe_point *profile, int count, int segments,
               int lobes);

/* A sphere, of twice as many segments as rings. */
void add_ball(struct surface *surface, const float center[3], float radius, int rings);

/* A straight moulding along x from -length/2 to length/2. The profile (z, y) goes counter-clockwise
 * seen from -x, where z runs to the right; all of it can be seen from its first point. */
void add_moulding(struct surface *surface, const float (*profile)[2], int count, float length);

/* A sheet of nu x nv squares with smooth normals; place gives the point at u and v in [0, 1], and
 * the front is where u to the right and v down are seen. Open. */
struct sheet {
    void (*place)(const void *context, float u, float v, float point[3]);
    const void *context;
    int nu, nv;
};
void add_sheet(struct surface *surface, const struct sheet *sheet);

/* Adds a piece turned about y by quarters of a turn (counter-clockwise from above), then moved. */
void add_copy(struct surface *surface, const struct surface *piece, int quarters,
              const float move[3]);

/* Sets the normals of all vertices from `first` on to the mean of the triangles around, weighted by
 * their angles at the vertex [Thuermer and Wuethrich 1998]. */
void smooth_normals(struct surface *surface, uint32_t first);

#endif
