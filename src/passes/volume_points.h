/* Surface points that fill volumes, by area, the same in each frame. They move with their
 * triangles. */
#ifndef PASSES_VOLUME_POINTS_H
#define PASSES_VOLUME_POINTS_H

#include "gl/buffer.h"
#include "scene/material.h"
#include "scene/mesh/surface_points.h"

struct volume_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* in its current pose, whose areas place the points */
    enum materials materials;
    bool smooth_black; /* glass and mirrors have albedo 0, because caustics carry their light */
    int count;         /* number of points by area */
    int per_triangle;  /* random points of each triangle in place of `count`; 0: by area */
    struct box box;    /* bounds of the points */
};

struct volume_points {
    struct volume_points_desc desc;
    struct surface_points points;
    unsigned dealt;            /* pose_count of the geometry at placement */
    unsigned pose;             /* pose of the last upload; 0: none */
    struct volume_point *room; /* upload buffer */
    bool *cut;                 /* parts of the geometry that reached beyond the box at placement */
    struct buffer buffer;
    GLuint vertices;
};

/* Returns the area of all triangles in the box, m2. */
double volume_points_area(const struct geometry *geometry, const struct box *box);

/* Error: a scene without area for points, or too many points. `area` is that of volume_points_area;
 * per_triangle 0: by area. */
bool volume_points_check(const struct geometry *geometry, double area, int per_triangle);

/* Returns the number of points on `area` that gives a crossed voxel of side `voxel` about
 * `per_voxel` points. */
int volume_points_count(double area, float voxel, float per_voxel);

/* Error: out of GPU memory. */
bool volume_points_init(struct volume_points *points, const struct volume_points_desc *desc);
void volume_points_free(struct volume_points *points);

/* True while the points cover all surfaces in the box; else create them anew. Metaballs change
 * their triangles with each pose. A moving part that crosses the box's sides shows another piece in
 * it. */
bool volume_points_fit(const struct volume_points *points, const struct geometry *geometry);

/* Moves the points to the geometry's pose. volume_points_fit must be true. */
void volume_points_place(struct volume_points *points, const struct geometry *geometry);

#endif
