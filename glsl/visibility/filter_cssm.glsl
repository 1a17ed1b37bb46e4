// Convolution soft shadow maps [Dong 2009 §4.1-4.2; Dong 2011 ch. 5].
//
// Distances are map depths: metres over the unit. With the argument a that the map's range makes of them, and b of
// the receiver's, the blocked fraction of a filter w is
//     s(b) = 1/2 + 2 sum_k (sin(c_k b) [w*cos c_k a] - cos(c_k b) [w*sin c_k a]) / c_k
// and the mean argument of the blockers is the same expansion of a, over s (eq. 5.10, 5.11).
#include "visibility/series.glsl"

layout(binding = UNIT_BASIS_COS) uniform sampler2DArray basis_cos;
layout(binding = UNIT_BASIS_SIN) uniform sampler2DArray basis_sin;
layout(binding = UNIT_BASIS_Z_COS) uniform sampler2DArray basis_z_cos;
layout(binding = UNIT_BASIS_Z_SIN) uniform sampler2DArray basis_z_sin;
layout(binding = UNIT_BASIS_Z) uniform sampler2DArray basis_z;

const float PI = 3.14159265358979;
const float BLOCKED_MIN = 0.02; // below it the division by s is noise: lit

// sin and cos of c_k b for the four terms of a group, and 2 / c_k (0 beyond the last term).
void terms(int group, float b, out vec4 s, out vec4 c, out vec4 weight) {
    vec4 k = vec4(0.0, 1.0, 2.0, 3.0) + float(4 * group);
    vec4 frequency = PI * (2.0 * k + 1.0);
    s = sin(frequency * b);
    c = cos(frequency * b);
    weight = mix(vec4(0.0), 2.0 / frequency, lessThan(k, vec4(BASIS_TERMS)));
}

float blocked_fraction(vec2 uv, int map, float b, float lod) {
    float sum = 0.5;
    for (int group = 0; group < BASIS_GROUPS; group++) {
        vec4 s, c, weight;
        terms(group, b, s, c, weight);
        vec3 at = vec3(uv, group * MAP_COUNT + map);
        vec4 wc = textureLod(basis_cos, at, lod) * 2.0 - 1.0;
        vec4 ws = textureLod(basis_sin, at, lod) * 2.0 - 1.0;
        sum += dot(weight, s * wc - c * ws);
    }
    return sum;
}

// The mean argument of what blocks; negative where (almost) nothing does.
float blocker_argument(vec2 uv, int map, float b, float lod) {
    float blocked = blocked_fraction(uv, map, b, lod);
    if (blocked < BLOCKED_MIN)
        return -1.0;
    float sum = 0.5 * textureLod(basis_z, vec3(uv, map), lod).r;
    for (int group = 0; group < BASIS_GROUPS; group++) {
        vec4 s, c, weight;
        terms(group, b, s, c, weight);
        vec3 at = vec3(uv, group * MAP_COUNT + map);
        sum += dot(weight, s * textureLod(basis_z_cos, at, lod) - c * textureLod(basis_z_sin, at, lod));
    }
    return max(sum / blocked, 0.0);
}

// A filter picks up the plane of a tilted receiver too, half of it nearer than the receiver, and the step is no
// straight line that would make up for that by the other half: the receiver is taken to be as near as the plane is
// at this share of the filter's width.
const float TILT = 0.125;

// The MIP level whose texel is half a filter of this width (a fraction of the map): a wider one picks
// up the tilted receiver itself.
float filter_lod(float width) {
    return max(0.0, log2(lookup.map_size * width) - 1.0);
}

float lit(int map, receiver r, float extent) {
    float d = r.distance / r.unit, light = extent_in_units(r, extent);
    series_range range = series_range_at(map);
    float b = series_receiver(range, d, lookup.shift);
    // The first filter: the light's own solid angle seen from the receiver.
    float initial = light_angle(r, light, d);
    float blocker = blocker_argument(r.uv, map, b, filter_lod(angle_width(r, initial)));
    if (blocker < 0.0)
        return 1.0;
    float z_average = clamp(series_depth(range, blocker), 1e-3 * d, d);
    float alpha = atan(penumbra_angle(light, d, z_average));
    b = series_receiver(range, d * (1.0 - min(TILT * alpha * receiver_slope(r), 0.5)), lookup.shift);
    float blocked = blocked_fraction(r.uv, map, b, filter_lod(angle_width(r, alpha)));
    // Ringing suppression by shift and scale [Dong 2011, Fig. 5.2].
    float share = clamp(0.5 - (blocked - 0.5) * lookup.gain, 0.0, 1.0);
#if SHARPEN
    // Contact shadows [Dong 2011, eq. 5.9]: G(v) = v^(1 + A exp(-B (d - z)))
    share = pow(share, 1.0 + lookup.sharpen_a * exp(-lookup.sharpen_b * (d - z_average)));
#endif
    return share;
}
