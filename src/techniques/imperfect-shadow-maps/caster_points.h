/* The points that imperfect shadow maps are made of, spread by area over all surfaces
 * (surface_points.h). They move with their triangles. */
#ifndef TECHNIQUES_CASTER_POINTS_H
#define TECHNIQUES_CASTER_POINTS_H

#include "gl/buffer.h"
#include "scene/mesh/surface_points.h"

struct caster_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* as it is posed now: points are dealt by its areas */
    int count;                       /* of one map */
    int sets;                        /* of so many each */
};

struct caster_points {
    struct caster_points_desc desc;
    struct surface_points points;
    bool dealt_by_pose;        /* metaballs have others in each */
    unsigned pose;             /* that they were uploaded for; 0: none */
    struct caster_point *room; /* for what is uploaded */
    float radius;              /* of all disks of a map together, were they alike, metres */
    struct buffer buffer;
};

bool caster_points_init(struct caster_points *points, const struct caster_points_desc *desc);
void caster_points_free(struct caster_points *points);

/* Puts them where the geometry is. */
void caster_points_place(struct caster_points *points, const struct geometry *geometry);

#endif
