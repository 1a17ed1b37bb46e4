/* Points spread evenly over the surfaces of a scene, of which shadows and volumes are made: each surface once, as both of
 * its sides hide light.
 *
 * Halton's points over the running sum of the triangles' areas: any run of the sequence is an even
 * subset. A triangle that would have more than a tenth of all points counts for a tenth, unless
 * by_area: a plain around a room takes few. With a box, points lie on what of each triangle is in it. Points keep their place in their triangle when it moves
 * or is deformed. Holes of alpha masks have none. Where there are metaballs, points are dealt anew
 * for each pose.
 */
#ifndef SCENE_MESH_SURFACE_POINTS_H
#define SCENE_MESH_SURFACE_POINTS_H

#include "scene/mesh/boxed.h"

struct surface_point {
    int part;
    uint32_t triangle; /* of the part's */
    float weight[3];   /* of its corners */
    float share;       /* of the triangle's area that it stands for */
};

struct surface_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* as it is posed now: points are dealt by its areas */
    int count;
    uint32_t first;        /* of the sequence: points first .. first + count */
    bool by_area;          /* no triangle has fewer points than its area asks for */
    const struct box *box; /* NULL: all */
    int per_triangle; /* in place of all others: so many random points of each triangle; 0: not so */
};

struct surface_points {
    int count;
    struct surface_point *items;
};

struct surface_place {
    vec3s position, normal; /* metres, unit */
    float area;             /* m2; 0: there is no such point */
};

void surface_points_init(struct surface_points *points, const struct surface_points_desc *desc);
void surface_points_free(struct surface_points *points);

/* Whether there are metaballs: each pose then has other triangles, and needs points of its own. */
bool surface_points_differ_by_pose(const struct geometry *geometry);

struct corners surface_point_corners(const struct surface_point *point,
                                     const struct geometry *geometry);
const struct material *surface_point_material(const struct surface_point *point,
                                              const struct scene *scene,
                                              const struct geometry *geometry);

struct surface_place surface_points_place(const struct surface_points *points,
                                          const struct geometry *geometry, int i);

#endif
