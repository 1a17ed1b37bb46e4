// A VAL as its bounding rectangle and its normal: instance k, five lines of two triangles each.
#include "passes/visibility/map_views.glsl"
#include "inspect/mark.glsl"

layout(binding = UNIT_VAL_EXTREMES) uniform sampler2D val_extremes;
layout(binding = UNIT_VAL_POSITION) uniform sampler2D val_positions; // w: count

flat out vec3 mark_color;
flat out float strength;
noperspective out float across; // pixels from the line's middle

vec4 corner(map_view v, vec4 extremes, int i) {
    vec3 bitangent = cross(v.axis, v.tangent);
    float s = i == 0 || i == 3 ? -extremes.z : extremes.x;
    float t = i < 2 ? -extremes.w : extremes.y;
    return camera.world_to_clip * vec4(v.center + s * v.tangent + t * bitangent, 1.0);
}

void main() {
    int k = gl_InstanceID, segment = gl_VertexID / 6, place = gl_VertexID % 6;
    map_view v = map_view_at(k);
    vec4 extremes = texelFetch(val_extremes, ivec2(k, 0), 0);
    vec4 from = corner(v, extremes, segment), to = corner(v, extremes, (segment + 1) % 4);
    if (segment == 4) {
        from = camera.world_to_clip * vec4(v.center, 1.0);
        to = camera.world_to_clip * vec4(v.center + v.axis * params.normal_length, 1.0);
    }
    vec2 along = (to.xy / to.w - from.xy / from.w) * params.picture;
    vec2 aside = vec2(-along.y, along.x) / max(length(along), 1e-6);
    // Corners 0 1 2, 2 1 3 of the strip.
    int index = place < 3 ? place : place == 3 ? 2 : place - 3;
    if (place == 5)
        index = 3;
    float side = index % 2 == 0 ? -1.0 : 1.0;
    float half_width = 0.5 * params.size * (k == params.chosen ? 1.6 : 1.0) + 1.0;
    gl_Position = index < 2 ? from : to;
    gl_Position.xy += aside * side * half_width * 2.0 / params.picture * gl_Position.w;
    across = side * half_width;
    mark_color = cluster_color(k);
    strength = cluster_strength(k);
    bool empty = texelFetch(val_positions, ivec2(k, 0), 0).w <= 0.0;
    if (empty || from.w <= 0.0 || to.w <= 0.0 || strength == 0.0)
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
