// What a light sees along one direction. Depth is reversed (shared/view.h). The light has no place, so its
// extent is the angle that it is seen under, and angles in the map are widths over the receiver's distance.
#include "shared/view.h"

struct receiver {
    vec3 point;  // lifted off its surface, in the map's frame: x right, y up, z along the axis
    vec3 normal; // in the map's frame
    vec2 uv;     // in the map
    vec2 half_size; // of the map
    float distance, unit;
};

bool project(view v, vec3 position, vec3 normal, out receiver r) {
    r.half_size = vec2(length(v.right), length(v.up));
    float texel = 2.0 * r.half_size.x / lookup.map_size;
    vec3 lifted = position + normal * (lookup.bias * texel);
    r.uv = (v.world_to_clip * vec4(lifted, 1.0)).xy * 0.5 + 0.5;
    r.distance = dot(lifted - v.origin, v.forward);
    r.point = vec3((r.uv * 2.0 - 1.0) * r.half_size, r.distance);
    r.normal = vec3(dot(normal, v.right) / r.half_size.x, dot(normal, v.up) / r.half_size.y,
                    dot(normal, v.forward));
    r.unit = v.far;
    return true;
}

// As of the paraboloid, but along the axis.
float receiver_distance(receiver r, ivec2 texel) {
    vec2 ndc = (vec2(texel) + 0.5) / lookup.map_size * 2.0 - 1.0;
    vec3 from_texel = vec3(r.point.xy - ndc * r.half_size, r.distance);
    float facing = r.normal.z;
    float plane = facing < -1e-3 ? dot(r.normal, from_texel) / facing : r.distance;
    return clamp(plane, r.distance * 0.5, r.distance) * (1.0 - lookup.map_bias);
}

float receiver_slope(receiver r) {
    return length(r.normal.xy) / max(-r.normal.z, 0.1);
}

float extent_in_units(receiver r, float extent) {
    return extent; // an angle
}

float map_depth(receiver r, float stored) {
    return stored > 0.0 ? 1.0 - stored : 1e30;
}

float light_angle(receiver r, float extent, float d) {
    return extent;
}

float penumbra_angle(float extent, float d, float z) {
    return max(d - z, 0.0) * extent / d;
}

float angle_width(receiver r, float angle) {
    return 0.5 * angle * r.distance / r.half_size.x;
}
