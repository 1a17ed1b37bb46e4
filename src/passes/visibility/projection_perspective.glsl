// What a light sees through a pyramid: a spot, a face of a cube. Depth is reversed (shared/view.h).
#include "shared/view.h"

struct receiver {
    vec3 point;  // lifted off its surface, in the map's frame: x right, y up, z along the axis
    vec3 normal; // in the map's frame
    vec2 uv;     // in the map
    vec2 half_size; // of the map where z = 1
    float distance, unit, near;
};

bool project(view v, vec3 position, vec3 normal, out receiver r) {
    r.half_size = vec2(length(v.right), length(v.up));
    float texel = 2.0 * r.half_size.x * dot(position - v.origin, v.forward) / lookup.map_size;
    vec3 lifted = position + normal * (lookup.bias * texel);
    vec4 clip = v.world_to_clip * vec4(lifted, 1.0);
    r.uv = clip.xy / clip.w * 0.5 + 0.5;
    r.distance = dot(lifted - v.origin, v.forward);
    r.point = vec3((r.uv * 2.0 - 1.0) * r.half_size, 1.0) * r.distance;
    r.normal = vec3(dot(normal, v.right) / r.half_size.x, dot(normal, v.up) / r.half_size.y,
                    dot(normal, v.forward));
    r.unit = v.far;
    r.near = v.near / v.far;
    return r.distance > 0.0;
}

// As of the paraboloid, but along the axis.
float receiver_distance(receiver r, ivec2 texel) {
    vec2 ndc = (vec2(texel) + 0.5) / lookup.map_size * 2.0 - 1.0;
    vec3 ray = vec3(ndc * r.half_size, 1.0);
    float facing = dot(r.normal, ray);
    float plane = facing < -1e-3 ? dot(r.normal, r.point) / facing : r.distance;
    return clamp(plane, r.distance * 0.5, r.distance) * (1.0 - lookup.map_bias);
}

float receiver_slope(receiver r) {
    float facing = max(-dot(r.normal, r.point) / r.distance, 0.1);
    return length(r.normal.xy) / facing;
}

float extent_in_units(receiver r, float extent) {
    return extent / r.unit;
}

float map_depth(receiver r, float stored) {
    return stored > 0.0 ? r.near / stored : 1e30;
}

// The light lies across the axis, as the map does, so that angles are their tangents.
float light_angle(receiver r, float extent, float d) {
    return extent / d;
}

float penumbra_angle(float extent, float d, float z) {
    return max(d - z, 0.0) * extent / z / d;
}

float angle_width(receiver r, float angle) {
    return 0.5 * angle / r.half_size.x;
}
