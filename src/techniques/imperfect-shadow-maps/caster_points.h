/* Points of imperfect shadow maps, spread by area over all surfaces (surface_points.h). They move
 * with their triangles. */
#ifndef TECHNIQUES_CASTER_POINTS_H
#define TECHNIQUES_CASTER_POINTS_H

#include "gl/buffer.h"
#include "scene/mesh/surface_points.h"

struct caster_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* in its current pose, whose areas place the points */
    int count;                       /* points of one map */
    int sets;                        /* number of sets of `count` points */
};

struct caster_points {
    struct caster_points_desc desc;
    struct surface_points points;
    /* Points are placed anew in each pose, because metaballs change their triangles. */
    bool dealt_by_pose;
    unsigned pose, dealt;      /* poses of the last upload and deal; 0: none */
    struct caster_point *room; /* upload buffer */
    float radius;              /* radius of a map's disks if all had equal area, metres */
    struct buffer buffer;
};

bool caster_points_init(struct caster_points *points, const struct caster_points_desc *desc);
void caster_points_free(struct caster_points *points);

/* Moves the points to the geometry's pose. */
void caster_points_place(struct caster_points *points, const struct geometry *geometry);

#endif
