/* A rectangular light as a point sees it: places on it that are even in solid angle [Urena et al.
 * 2013, An Area-Preserving Parametrization for Spherical Rectangles]. */
#ifndef REFERENCE_SCENE_RECTANGLE_H
#define REFERENCE_SCENE_RECTANGLE_H

#include "base/unit.h"
#include "scene/lights/emitter.h"

struct seen_rectangle {
    double x[2], y[2], z; /* of the corners, from the point, along right, up and across; z < 0 */
    double solid_angle;   /* sr */
    double normal_y[2];   /* of the planes through the point and the sides at y[0] and y[1] */
    double first;         /* what the angle of the area left of x is counted from */
};

/* False where it is seen too small or too flat for it to matter: even places in its area will do. */
bool rectangle_see(struct seen_rectangle *seen, const struct emitter *light, vec3s from);

/* The place as emitter_piece has it. */
vec2s rectangle_place(const struct seen_rectangle *seen, vec2s sample);

#endif
