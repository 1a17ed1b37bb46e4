/* Maps from the unit square to directions and discs. */
#ifndef REFERENCE_WARP_H
#define REFERENCE_WARP_H

#include "base/unit.h"

/* A unit vector perpendicular to a unit vector, the same as glsl/lib/tangent.glsl's. */
vec3s warp_perpendicular(vec3s axis);

/* A unit direction with density cos / pi about the normal. */
vec3s warp_to_cosine(vec2s sample, vec3s normal);

/* A unit direction, uniform in the cone about the axis; cos_half_angle -1 is the whole sphere. */
vec3s warp_to_cone(vec2s sample, vec3s axis, float cos_half_angle);

/* The same by the height of the cone's cap, 1 - cos_half_angle, which tells narrow cones apart. */
vec3s warp_to_cap(vec2s sample, vec3s axis, float height);

/* A point, uniform in the unit disc across the axis. */
vec3s warp_to_disc(vec2s sample, vec3s axis);

#endif
