// Points into imperfect shadow maps: instance k draws the points of VPL first + k into layer k of the array.
#extension GL_ARB_shader_viewport_layer_array : require
#include "passes/visibility/map_views.glsl"
#include "passes/visibility/paraboloid.glsl"
#include "shared/splat.h"

PASS_BLOCK(splat_params, 32)

layout(binding = UNIT_CASTER_POINTS) uniform samplerBuffer caster_points; // their rows

flat out vec3 center, normal;  // in the map's frame, metres
flat out float map_depth;
flat out vec2 radius_and_unit; // metres
flat out float width;          // texels

caster_point caster_point_of(int map) {
    int set = (params.first + map) % params.sets;
    int row = (set * params.points + gl_VertexID) * CASTER_POINT_ROWS;
    vec4 place = texelFetch(caster_points, row), tilt = texelFetch(caster_points, row + 1);
    return caster_point(place.xyz, place.w, tilt.xyz, 0.0);
}

// What is too near is the VPL's own surface.
bool is_seen(map_view v, vec3 q, float radius) {
    return radius > 0.0 && paraboloid_above(q) > 0.0 && length(q) > max(v.near, radius);
}

// Straight on; the map takes an angle for so many texels.
float diameter(vec2 p, float radius, float distance) {
    return 2.0 * radius / distance * params.map_size * (1.0 + dot(p, p)) * 0.25;
}

void main() {
    int map = gl_InstanceID;
    map_view v = map_view_at(map);
    caster_point point = caster_point_of(map);
    vec3 q = paraboloid_local(v, point.position);
    float distance = length(q), radius = point.radius * params.scale;
    vec2 p = paraboloid_project(q / max(distance, 1e-20));
    float size = diameter(p, radius, distance);
    center = q;
    normal = paraboloid_rotate(v, point.normal);
    radius_and_unit = vec2(radius, v.z_far);
#if SPLAT == SPLAT_DISK
    float depth = distance;
    size += 1.0; // the texels that its rim cuts, too
#else
    // As wide as a square of the disk's area; and behind the point by what a receiver of the same surface may be
    // nearer within the square, and within a texel.
    const float SQUARE = 0.88622692545; // sqrt(pi) / 2
    float depth = distance + 2.0 * radius + 4.0 * distance / params.map_size;
    size *= SQUARE;
#endif
    width = clamp(size, 1.0, params.map_size * 0.25);
    map_depth = min(depth / v.z_far, 1.0);
    bool seen = is_seen(v, q, radius);
    gl_Position = seen ? vec4(p, map_depth, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = width;
    gl_Layer = map;
}
