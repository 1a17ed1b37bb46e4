// A light's own map: depth along its axis, linear.
#include "passes/visibility/light_map.glsl"

struct receiver {
    vec2 s, uv;  // in the light's plane, in the map
    vec2 slope;  // of the receiver's own plane: what a step of s adds to its depth or, seen from a place, to the inverse,
                 // of its own
    vec2 sides;  // of the light, in the unit of s at a depth of 1 m
    float plain; // struct light_map's
    bool orthographic;
    float distance, unit; // along the axis
};

bool project(light_map m, vec3 position, vec3 normal, out receiver r) {
    vec2 half_size = vec2(length(m.right), length(m.up));
    vec2 right_up2 = half_size * half_size;
    vec3 from = position - m.origin;
    float depth = dot(from, m.forward);
    r.orthographic = m.orthographic;
    r.plain = m.plain;
    r.unit = m.unit;
    float spread = r.orthographic ? 1.0 : depth;
    // A texel is wider where the plane is drawn together.
    vec2 wide = max(abs(vec2(dot(from, m.right), dot(from, m.up))) / (right_up2 * max(spread, 1e-6 * m.unit)), 1.0);
    float texel = 2.0 * half_size.x * spread / (m.plain * lookup.map_size) * wide.x * wide.y;
    from += normal * (lookup.bias * texel);
    depth = dot(from, m.forward);
    r.distance = depth;
    r.s = vec2(dot(from, m.right), dot(from, m.up)) / (right_up2 * (r.orthographic ? 1.0 : depth));
    r.uv = light_map_place(m.plain, r.s) * 0.5 + 0.5;
    vec2 across = vec2(dot(normal, m.right), dot(normal, m.up));
    float facing = dot(normal, m.forward) + (r.orthographic ? 0.0 : dot(across, r.s));
    r.slope = facing < -1e-3 ? across / facing : vec2(0.0);
    r.sides = m.sides / half_size;
    if (m.is_sphere) // a disk that faces the receiver, as its plane has it
        r.sides *= sqrt(1.0 + r.s * r.s * right_up2);
    return depth > 0.0;
}

// Where the receiver's plane is met, metres; no nearer than a share of the receiver's distance. Where it is farther than
// the receiver, the receiver is: in a corner the plane goes on behind the other wall.
float plane_depth_from(receiver r, vec2 uv, float share) {
    float beyond = dot(r.slope, light_map_plane(r.plain, uv * 2.0 - 1.0) - r.s);
    return r.orthographic ? clamp(r.distance - beyond, share * r.distance, r.distance)
                          : r.distance / clamp(1.0 + beyond, 1.0, 1.0 / share);
}

float plane_depth(receiver r, vec2 uv) {
    return plane_depth_from(r, uv, 0.8);
}

float receiver_distance(receiver r, ivec2 texel) {
    return plane_depth(r, (vec2(texel) + 0.5) / lookup.map_size) * (1.0 - lookup.map_bias);
}

float map_depth(receiver r, float stored) {
    return stored < 1.0 ? stored : 1e30;
}

// The part of the map, from low to high, that ways from the receiver to the light pass at that depth (over the unit): at
// least a texel.
vec4 window(receiver r, float extent, float depth) {
    float z = depth * r.unit, beyond = max(r.distance - z, 0.0);
    vec2 reach = 0.5 * r.sides * (r.orthographic ? beyond : beyond / (r.distance * z));
    vec2 low = light_map_place(r.plain, r.s - reach) * 0.5 + 0.5, high = light_map_place(r.plain, r.s + reach) * 0.5 + 0.5;
    vec2 texel = vec2(0.51 / lookup.map_size); // half of one, and of what rounding takes
    vec2 middle = clamp(r.uv, texel, 1.0 - texel);
    return vec4(max(min(low, middle - texel), 0.0), min(max(high, middle + texel), 1.0));
}
