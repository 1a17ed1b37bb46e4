/* Points spread evenly over the surfaces of a scene: where light of further bounces is gathered, or what
 * shadows are made of.
 *
 * Halton's points over the running sum of the triangles' areas: any run of the sequence is an even
 * subset. A triangle that would have more than a tenth of all points counts for a tenth: a plain
 * around a room takes few. Points keep their place in their triangle when it moves or is deformed. Holes of
 * alpha masks have none.
 *
 * Where light is gathered, what reflects nothing has none either: black surfaces, and the backs of single-sided
 * ones; nor have metaballs, whose triangles come and go: points would jump from frame to frame. Casters have them
 * all, each surface once: both of its sides hide light. Where there are metaballs, they are dealt anew for each pose.
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

struct surface_points_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* as it is posed now: points are dealt by its areas */
    int count;
    uint32_t first; /* of the sequence: points first .. first + count */
    bool casters;
    int seed; /* 0 = Halton's points as they are; else shifted on the torus */
};

struct surface_points {
    int count;
    struct surface_point *items;
};

/* A place and what it reflects. */
struct surface_place {
    vec3s position, normal, albedo; /* metres, unit */
    float area;                     /* m2; 0: there is no such point */
};

void surface_points_init(struct surface_points *points, const struct surface_points_desc *desc);
void surface_points_free(struct surface_points *points);

struct surface_place surface_points_place(const struct surface_points *points,
                                          const struct geometry *geometry, int i);

#endif
