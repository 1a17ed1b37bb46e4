// Vertex k becomes the paraboloid view from VAL k. The extent is the side of the square as large as the
// bounding rectangle.
//
// The mean of VPLs on a ball lies within the ball, which then hides all the rest: a mean behind the tangent
// plane of the VPL that is nearest to it is moved onto that plane, and the map looks from there.
#include "lib/tangent.glsl"
#include "lib/map_range.glsl"
#include "lib/val_distance.glsl"

layout(binding = UNIT_VAL_EXTREMES) uniform sampler2D val_extremes;
layout(binding = UNIT_VPLS) uniform samplerBuffer vpls; // with their VALs' numbers

out vec4 view_center, view_axis, view_tangent;

// spacing: of the VPLs there, metres.
vec3 on_surface(int k, vec3 center, vec3 mean, out float spacing) {
    vec3 foot = center;
    float least = 1e30;
    spacing = 0.0;
    for (int i = 0; i < int(params.vpl_count); i++) {
        vec4 position = texelFetch(vpls, 3 * i);
        vec4 normal = texelFetch(vpls, 3 * i + 1);
        bool lights = int(position.w) == k && texelFetch(vpls, 3 * i + 2).w > 0.0;
        float d = val_distance(position.xyz, normal.xyz, center, mean);
        if (lights && d < least) {
            least = d;
            foot = center + normal.xyz * max(dot(position.xyz - center, normal.xyz), 0.0);
            spacing = sqrt(normal.w);
        }
    }
    return foot;
}

void main() {
    ivec2 k = ivec2(gl_VertexID, 0);
    vec3 normal = texelFetch(val_normals, k, 0).xyz;
    float spacing;
    vec3 center = on_surface(gl_VertexID, texelFetch(val_positions, k, 0).xyz, normal, spacing);
    vec4 extremes = texelFetch(val_extremes, k, 0);
    vec2 sides = max(extremes.xy + extremes.zw, vec2(0.0));
    float z_far = farthest_corner(center, params.bounds_min.xyz, params.bounds_max.xyz);
    view_center = vec4(center, z_far / params.depth_range);
    float extent = sqrt(sides.x * sides.y);
    view_axis = vec4(normal, extent);
    // What the VAL itself spans may be left out, but no more, however large the scene is.
    view_tangent = vec4(perpendicular(normal), min(params.near_clip, max(extent, spacing)));
}
