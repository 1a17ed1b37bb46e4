/* Points spread evenly over the surfaces of a scene: where light of further bounces is gathered.
 *
 * Halton's points over the running sum of the triangles' areas: any run of the sequence is an even
 * subset. A triangle that would have more than a tenth of all points counts for a tenth: a plain
 * around a room takes few. Points keep their place in their triangle when it moves or is deformed. What
 * reflects nothing has none: holes of alpha masks, black surfaces, and the backs of single-sided ones; nor
 * have metaballs, whose triangles come and go: points would jump from frame to frame.
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
    vec3s albedo;
};

struct surface_points {
    const struct scene *scene;
    int count;
    struct surface_point *items;
};

/* A place and what it reflects. */
struct surface_place {
    vec3s position, normal, albedo; /* metres, unit */
    float area;                     /* m2 */
};

/* Deals out points first .. first + count of the sequence by the geometry's present pose. */
void surface_points_init(struct surface_points *points, const struct scene *scene,
                         const struct geometry *geometry, int count, uint32_t first);
void surface_points_free(struct surface_points *points);

struct surface_place surface_points_place(const struct surface_points *points,
                                          const struct geometry *geometry, int i);

#endif
