// The half space in front of a VAL or VPL; map depth is the distance over z_far.
#include "passes/visibility/paraboloid.glsl"

struct receiver {
    vec3 point;     // lifted off its surface, in the map's frame
    vec3 normal;    // in the map's frame
    vec3 direction; // unit
    vec2 place, uv; // in the map: place in [-1, 1]
    float distance, unit;
};

// Where a ray begins the slope within the texel is known (passes/visibility/visibility.glsl). Lifted as far as all others, what is
// round is lit behind its horizon, and leaves and rails of a texel lose the shade that they cast beside them.
#if FILTER == FILTER_RAY
const float LIFTED = 0.4;
#else
const float LIFTED = 1.0;
#endif

// The point is lifted off its surface by so many of the map's texels, as wide as they are at its distance:
// a surface must not shadow itself where a texel of it is deeper than its middle. A texel in the middle of
// the map spans 4 / size radians.
bool project(map_view v, vec3 position, vec3 normal, out receiver r) {
    float texel = 4.0 / lookup.map_size * distance(position, v.center);
    r.point = paraboloid_local(v, position + normal * (LIFTED * lookup.bias * texel));
    r.normal = paraboloid_rotate(v, normal);
    r.distance = length(r.point);
    r.direction = r.point / r.distance;
    r.place = paraboloid_project(r.direction);
    r.uv = r.place * 0.5 + 0.5;
    r.unit = v.z_far;
    return r.point.z > 0.0; // the map knows nothing behind its plane [Dong 2009 Fig. 7]
}

// Where the plane, met in the texel's own direction, is nearer than the point, that is compared: it does not
// shadow itself however it is tilted. Where it is farther, the point is: in a corner the plane goes on behind
// the other wall.
float receiver_distance(receiver r, ivec2 texel) {
    vec3 direction = paraboloid_direction((vec2(texel) + 0.5) / lookup.map_size * 2.0 - 1.0);
    float facing = dot(r.normal, direction);
    float plane = facing < -1e-3 ? dot(r.normal, r.point) / facing : r.distance;
    // A round wall, seen from inside, bends off its plane by about the squared angle.
    float bend = 2.0 - 2.0 * dot(direction, r.point) / r.distance;
    return clamp(plane, r.distance * 0.5, r.distance) * (1.0 - lookup.map_bias - bend);
}

float receiver_slope(receiver r) {
    float facing = clamp(-dot(r.normal, r.direction), 0.1, 1.0);
    return sqrt(1.0 - facing * facing) / facing;
}

float extent_in_units(receiver r, float extent) {
    return extent / r.unit;
}

float map_depth(receiver r, float stored) {
    return stored;
}

// The side of a square that faces the light's axis.
float light_angle(receiver r, float extent, float d) {
    return extent * sqrt(max(r.direction.z, 0.05)) / d;
}

// Seen from the light's centre [Dong 2009 §4.2]: p cos beta = (d - z) extent / z.
float penumbra_angle(float extent, float d, float z) {
    return max(d - z, 0.0) * extent / z / d;
}

// By the projection's Jacobian (1 + |p|^2) / 4, or everywhere alpha / pi as the paper has it.
float angle_width(receiver r, float angle) {
#if JACOBIAN
    return angle * (1.0 + dot(r.place, r.place)) * 0.25;
#else
    return angle / 3.14159265358979;
#endif
}
