// Vertex i becomes the paraboloid view from VPL first + i: a light without extent. What is nearer than the
// next VPL may be left out, but no more, however large the scene is.
#include "lib/tangent.glsl"
#include "lib/map_range.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    map_params params;
};
layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position;
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal;

out vec4 view_center, view_axis, view_tangent;

void main() {
    float z_far = farthest_corner(position.xyz, params.bounds_min.xyz, params.bounds_max.xyz);
    view_center = vec4(position.xyz, z_far / params.depth_range);
    view_axis = vec4(normal.xyz, 0.0);
    view_tangent = vec4(perpendicular(normal.xyz), min(params.near_clip, sqrt(normal.w)));
}
