/* Points spread uniformly over a scene's surfaces, for shadows and volumes. Each surface counts
 * once, because both of its sides block light.
 *
 * Points follow Halton's sequence over the cumulative area of the triangles, so each run is a
 * uniform subset. A triangle has at most a tenth of the points unless by_area, so that a ground
 * plane takes few. With a box, points are on the part of each triangle inside it. Points keep their
 * barycentric position when triangles move or deform. Holes of alpha masks have none. With
 * metaballs each pose has new points. */
#ifndef SCENE_MESH_SURFACE_POINTS_H
#define SCENE_MESH_SURFACE_POINTS_H

#include "scene/mesh/boxed.h"

struct surface_point {
    int part;
    uint32_t triangle; /* of the part */
    float weight[3];   /* barycentric */
    float share;       /* fraction of the triangle's area that the point represents */
};

struct surface_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* in its current pose, whose areas place the points */
    int count;
    uint32_t first;        /* index in the sequence: points first to first + count - 1 */
    bool by_area;          /* points are strictly proportional to area */
    const struct box *box; /* NULL: unbounded */
    int per_triangle;      /* random points of each triangle in place of all others; 0: off */
};

struct surface_points {
    int count;
    struct surface_point *items;
};

struct surface_place {
    vec3s position, normal; /* metres, unit */
    float area;             /* m2; 0: the point does not exist */
};

void surface_points_init(struct surface_points *points, const struct surface_points_desc *desc);
void surface_points_free(struct surface_points *points);

/* True with metaballs: each pose has other triangles and needs its own points. */
bool surface_points_differ_by_pose(const struct geometry *geometry);

struct corners surface_point_corners(const struct surface_point *point,
                                     const struct geometry *geometry);
const struct material *surface_point_material(const struct surface_point *point,
                                              const struct scene *scene,
                                              const struct geometry *geometry);

struct surface_place surface_points_place(const struct surface_points *points,
                                          const struct geometry *geometry, int i);

#endif
