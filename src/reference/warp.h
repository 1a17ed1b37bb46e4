/* Maps the unit square to directions and disks. */
#ifndef REFERENCE_WARP_H
#define REFERENCE_WARP_H

#include "base/unit.h"

/* Returns a unit vector perpendicular to a unit vector, as glsl/lib/direction.glsl has it. */
vec3s warp_perpendicular(vec3s axis);

/* Returns a unit direction with density cos / pi about the normal. */
vec3s warp_to_cosine(vec2s sample, vec3s normal);

/* Returns a unit direction, uniform in the cone about the axis. cos_half_angle -1: the whole
 * sphere. */
vec3s warp_to_cone(vec2s sample, vec3s axis, float cos_half_angle);

/* Returns a direction as warp_to_cone, by the height of the cone's cap, 1 - cos_half_angle. It is
 * precise for narrow cones. */
vec3s warp_to_cap(vec2s sample, vec3s axis, float height);

/* Returns a point, uniform in the unit disk perpendicular to the axis. */
vec3s warp_to_disc(vec2s sample, vec3s axis);

#endif
