/* Bodies of bones and muscles, melted together: an implicit surface for marching cubes.
 *
 * Each part is a rough distance, negative inside; parts join by a smooth minimum, in the order in
 * which they were added. */
#ifndef SCENES_SOFT_BODY_H
#define SCENES_SOFT_BODY_H

#include "scene/shapes/marching_cubes.h"

#include <stdbool.h>

/* A cone with round ends. */
struct bone {
    float from[3], from_radius;
    float to[3], to_radius;
    float flat;  /* thickness in z over that in the other directions; 0 = round */
    float blend; /* width of the seam with what is there already */
};

/* An ellipsoid, turned about z by `tilt` degrees. */
struct muscle {
    float center[3], radii[3];
    float tilt, blend;
};

/* Where parts are placed: p = origin + x right + y up + z front; orthonormal. */
struct soft_frame {
    float origin[3], right[3], up[3], front[3];
};

enum { SOFT_PARTS_MAX = 256 };

struct soft_part {
    struct soft_frame frame; /* a bone is placed in it; an ellipsoid's axes are its own */
    bool is_bone, carve;
    struct bone bone;
    struct muscle muscle;
    float low[3], high[3]; /* beyond this box it has no influence */
};

struct soft_body {
    int count;
    struct soft_part parts[SOFT_PARTS_MAX];
};

enum soft_side { SOFT_ONE, SOFT_BOTH /* and mirrored in the frame's z */ };

void soft_add_bone(struct soft_body *body, const struct soft_frame *frame, const struct bone *bone,
                   enum soft_side side);
void soft_add_muscle(struct soft_body *body, const struct soft_frame *frame,
                     const struct muscle *muscle, enum soft_side side);
/* Takes the ellipsoid away instead. */
void soft_carve(struct soft_body *body, const struct soft_frame *frame, const struct muscle *muscle,
                enum soft_side side);

/* The body as a field; it must outlive it. */
struct implicit soft_implicit(const struct soft_body *body);

/* A grid around all parts. */
struct marching_grid soft_grid(const struct soft_body *body, float step);

#endif
