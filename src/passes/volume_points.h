/* Points of the surfaces that volumes are made of, by area and the same in each frame. They move with their triangles. */
#ifndef PASSES_VOLUME_POINTS_H
#define PASSES_VOLUME_POINTS_H

#include "gl/buffer.h"
#include "scene/material.h"
#include "scene/mesh/surface_points.h"

struct volume_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* as it is posed now: points are dealt by its areas */
    enum materials materials;
    bool smooth_black; /* glass and mirrors reflect nothing: caustics carry their light */
    int count;         /* by area */
    int per_triangle;  /* in place of it: random ones; 0: none */
    struct box box;    /* where they lie */
};

struct volume_points {
    struct volume_points_desc desc;
    struct surface_points points;
    unsigned dealt;            /* pose whose triangles they lie on */
    unsigned pose;             /* that they were uploaded for; 0: none */
    struct volume_point *room; /* what is uploaded */
    bool *cut; /* parts of the geometry that reached beyond the box when they were dealt */
    struct buffer buffer;
    GLuint vertices;
};

/* Of all that is in the box, m2. */
double volume_points_area(const struct geometry *geometry, const struct box *box);

/* Refuses a scene on which no points lie, and one with too many. area: volume_points_area's; per_triangle 0: by area. */
bool volume_points_check(const struct geometry *geometry, double area, int per_triangle);

/* How many points on that area give a voxel of that side so many where a surface crosses it. */
int volume_points_count(double area, float voxel, float per_voxel);

/* Error: out of GPU memory. */
bool volume_points_init(struct volume_points *points, const struct volume_points_desc *desc);
void volume_points_free(struct volume_points *points);

/* Whether they lie on all that is in the box; else they are to be made anew. Metaballs have other triangles in each pose.
 * Of a part that moves across the box's sides another piece is in the box. */
bool volume_points_fit(const struct volume_points *points, const struct geometry *geometry);

/* Puts them where the geometry is; they fit. */
void volume_points_place(struct volume_points *points, const struct geometry *geometry);

#endif
