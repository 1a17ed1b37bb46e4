// Into how many pieces the edges of a long caster fall: the projection bends straight lines, and the
// rasteriser draws pieces of them straight. The decision looks at an edge's two ends alone: triangles that
// share it divide it alike, and no crack opens.
#include "visibility/map_views.glsl"
#include "visibility/paraboloid.glsl"
#include "shared/paraboloid.h"

layout(vertices = 3) out;

in vec3 corner[];
in int map[];
out vec3 patch_corner[];
patch out int patch_map;
patch out vec3 patch_angles; // that the edges across from the corners span
#ifdef MASKED
in vec2 corner_uv[];
out vec2 patch_uv[];
#endif

// A line and the centre span a plane, whose image is a circle of radius 1 / |z of its normal|, and straight
// where it holds the axis. A piece of n strays from its chord by the square of its length there over 8 radii.
float pieces(vec3 a, vec3 b, float angle) {
    vec3 across = cross(a, b);
    float bend = abs(across.z) / max(length(across), 1e-20);
    float stretch = 1.0 / (1.0 + max(0.0, min(a.z / length(a), b.z / length(b))));
    bool is_long = distance(a, b) > params.long_edge;
    return is_long ? clamp(angle * stretch * sqrt(bend) * params.pieces, 1.0, PARABOLOID_PIECES_MAX) : 1.0;
}

float angle_between(vec3 a, vec3 b) {
    return atan(length(cross(a, b)), dot(a, b));
}

// What lies all below the map's plane; and the surface that the centre itself lies on, or no farther off than
// what is left out as too near: seen edge-on, a texel of it is many depths, and it would shadow itself.
bool is_left_out() {
    vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    float highest = max(paraboloid_above(corner[0]), max(paraboloid_above(corner[1]), paraboloid_above(corner[2])));
    return highest <= 0.0 || abs(dot(normal, corner[0])) < map_view_at(map[0]).near * length(normal);
}

void main() {
    patch_corner[gl_InvocationID] = corner[gl_InvocationID];
#ifdef MASKED
    patch_uv[gl_InvocationID] = corner_uv[gl_InvocationID];
#endif
    if (gl_InvocationID > 0)
        return;
    patch_map = map[0];
    float most = 1.0;
    for (int i = 0; i < 3; i++) {
        vec3 a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
        patch_angles[i] = angle_between(a, b);
        gl_TessLevelOuter[i] = pieces(a, b, patch_angles[i]);
        most = max(most, gl_TessLevelOuter[i]);
    }
    gl_TessLevelInner[0] = max(0.5 * most, 1.0);
    if (is_left_out())
        gl_TessLevelOuter[0] = 0.0;
}
