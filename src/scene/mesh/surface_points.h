/* Points spread evenly over the surfaces of a scene: where light of further bounces is gathered.
 *
 * Halton's points over the running sum of the triangles' areas: any run of the sequence is an even
 * subset. A triangle that would have more than a tenth of all points counts for a tenth: a plain
 * around a room takes few. Points keep their place in their triangle when it moves or is deformed;
 * on metaballs, whose triangles come and go, their place in the sum of areas. What reflects nothing has
 * none: holes of alpha masks, black surfaces, and the backs of single-sided ones.
 */
#ifndef SCENE_MESH_SURFACE_POINTS_H
#define SCENE_MESH_SURFACE_POINTS_H

#include "scene/mesh/corners.h"

struct surface_point {
    int part;
    uint32_t triangle; /* of the part's */
    float weight[3];   /* of its corners */
    bool back;         /* it lies on the back of a double-sided surface */
    float share;       /* of the triangle's area that it stands for */
    /* On metaballs: its share of the part's area, and its place in the part's running sum, over the
     * whole. */
    float part_share;
    double along;
    vec3s albedo;
};

struct surface_points {
    const struct scene *scene;
    int count;
    struct surface_point *items;
    unsigned pose; /* that the metaballs' triangles were looked up for */
};

/* A place and what it reflects. */
struct surface_place {
    vec3s position, normal, albedo; /* metres, unit */
    float area;                     /* m2 */
};

/* Deals out points first .. first + count of the sequence by the geometry's present pose. */
void surface_points_init(struct surface_points *points, const struct scene *scene,
                         const struct geometry *geometry, int count, int first);
void surface_points_free(struct surface_points *points);

/* After the geometry has moved. */
void surface_points_follow(struct surface_points *points, const struct geometry *geometry);

struct surface_place surface_points_place(const struct surface_points *points,
                                          const struct geometry *geometry, int i);

#endif
