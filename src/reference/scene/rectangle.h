/* Samples a rectangular light uniformly in solid angle [Urena et al. 2013, An Area-Preserving
 * Parametrization for Spherical Rectangles]. */
#ifndef REFERENCE_SCENE_RECTANGLE_H
#define REFERENCE_SCENE_RECTANGLE_H

#include "base/unit.h"
#include "scene/lights/emitter.h"

struct seen_rectangle {
    double x[2], y[2], z; /* corners relative to the point, along right, up and across; z < 0 */
    double solid_angle;   /* sr */
    double normal_y[2]; /* normals of the planes through the point and the sides at y[0] and y[1] */
    double first;       /* offset of the angle of the area left of x */
};

/* Prepares the light as seen from a point. False: too small or flat; uniform places in area then
 * suffice. */
bool rectangle_see(struct seen_rectangle *seen, const struct emitter *light, vec3s from);

/* Returns the place in the form of emitter_piece. */
vec2s rectangle_place(const struct seen_rectangle *seen, vec2s sample);

#endif
