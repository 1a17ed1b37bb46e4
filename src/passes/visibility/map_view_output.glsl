// A map's view as transform feedback captures it.
#include "shared/maps.h"

layout(xfb_buffer = 0, xfb_stride = 48) out;
layout(xfb_offset = 0) out vec4 captured_center_and_z_far;
layout(xfb_offset = 16) out vec4 captured_axis_and_extent;
layout(xfb_offset = 32) out vec4 captured_tangent_and_near;

void map_view_output(map_view v) {
    captured_center_and_z_far = vec4(v.center, v.z_far);
    captured_axis_and_extent = vec4(v.axis, v.extent);
    captured_tangent_and_near = vec4(v.tangent, v.near);
}

// The distance from a point to the farthest corner of a box.
float farthest_corner(vec3 from, vec3 bounds_min, vec3 bounds_max) {
    return length(max(abs(from - bounds_min), abs(from - bounds_max)));
}
