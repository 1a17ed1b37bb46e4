// Vertex k becomes the paraboloid view from VAL k. The extent is the side of the square as large as the
// bounding rectangle.
#include "lib/frame.glsl"
#include "lib/map_range.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    cluster_params params;
};
layout(binding = 0) uniform sampler2D val_positions;
layout(binding = 1) uniform sampler2D val_normals;
layout(binding = 2) uniform sampler2D val_extremes;

out vec4 view_center, view_axis, view_tangent;

void main() {
    ivec2 k = ivec2(gl_VertexID, 0);
    vec4 position = texelFetch(val_positions, k, 0);
    vec3 normal = texelFetch(val_normals, k, 0).xyz;
    vec4 extremes = texelFetch(val_extremes, k, 0);
    vec2 sides = max(extremes.xy + extremes.zw, vec2(0.0));
    float z_far = farthest_corner(position.xyz, params.bounds_min.xyz, params.bounds_max.xyz);
    view_center = vec4(position.xyz, z_far / params.depth_range);
    view_axis = vec4(normal, sqrt(sides.x * sides.y));
    view_tangent = vec4(perpendicular(normal), params.near_clip);
}
