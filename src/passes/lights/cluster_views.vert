// Vertex k becomes the paraboloid view from VAL k. The extent is the side of the square as large as the
// bounding rectangle.
//
// The mean of VPLs in a corner hangs in the air, and that of those around an opening lies in it, where none of
// them is: the map looks from the VPL that is nearest to the mean, as high above it as the mean lies. The mean of
// VPLs on a ball lies within, and a place on the ball would see but a side of it: such a mean is moved onto the
// tangent plane.
#include "passes/visibility/map_view_output.glsl"
#include "lib/direction.glsl"
#include "shared/cluster.h"
#include "passes/lights/val_distance.glsl"
#include "lib/vpl_texels.glsl" // with their VALs' numbers

layout(binding = UNIT_VAL_EXTREMES) uniform sampler2D val_extremes;

// How far below the VPL's plane a mean lies that is taken for a ball's, over its distance: from none to all.
const float WITHIN_FROM = 0.05, WITHIN_TO = 0.2;

vec3 viewpoint_above(vec3 mean, vpl nearest) {
    vec3 off = mean - nearest.position;
    float height = dot(off, nearest.normal);
    float within = smoothstep(WITHIN_FROM, WITHIN_TO, -height / max(length(off), 1e-20));
    return mix(nearest.position, mean - height * nearest.normal, within) + max(height, 0.0) * nearest.normal;
}

// spacing: of the VPLs there, metres.
vec3 viewpoint(int k, vec3 mean, out float spacing) {
    vec3 found = mean;
    float least = 1e30, weight_position = position_weight();
    spacing = 0.0;
    for (int i = 0; i < params.vpl_count; i++) {
        vpl v = vpl_at(i);
        bool lights = int(v.val) == k && v.reach > 0.0;
        float d = val_distance(weight_position, v, k);
        if (lights && d < least) {
            least = d;
            found = viewpoint_above(mean, v);
            spacing = sqrt(v.area);
        }
    }
    return found;
}

void main() {
    ivec2 k = ivec2(gl_VertexID, 0);
    vec3 normal = texelFetch(val_normals, k, 0).xyz;
    float spacing;
    vec3 center = viewpoint(gl_VertexID, texelFetch(val_positions, k, 0).xyz, spacing);
    vec4 extremes = texelFetch(val_extremes, k, 0);
    vec2 sides = max(extremes.xy + extremes.zw, vec2(0.0));
    float z_far = farthest_corner(center, params.bounds_min, params.bounds_max);
    float extent = sqrt(sides.x * sides.y);
    // What the VPLs themselves span may be left out, but no more.
    float near = min(params.near_clip * vpl_spread(), spacing);
    bool empty = texelFetch(val_positions, k, 0).w == 0.0;
    map_view_output(map_view(center, z_far, normal, extent, perpendicular(normal), empty ? MAP_VIEW_EMPTY : near));
}
