// The filter of VALs' maps, by FILTER (shared/maps.h).
#if FILTER == FILTER_HARD
// A binary lookup in one texel.
#include "passes/visibility/depth_maps.glsl"

float lit(int map, receiver r, float extent) {
    return texel_sees(map, r, ivec2(r.uv * lookup.map_size)) ? 1.0 : 0.0;
}
#elif FILTER == FILTER_PLANE
// A binary lookup in one texel of a paraboloid map that knows its casters' planes. Where a texel's middle sees
// something nearer than the receiver, its plane, met in the receiver's own direction, may yet lie behind: in a
// corner the other wall does. A triangle then hides nothing there, so that neither walls beside nor the
// receiver's own surface need a depth bias.
#include "lib/direction.glsl"
#include "passes/visibility/depth_maps.glsl"

layout(binding = UNIT_MAP_NORMAL) uniform sampler2DArray map_normals;

// Depths are stored in so many steps.
const float DEPTH_STEPS = 65535.0;

bool plane_hides(int map, receiver r, ivec2 texel) {
    vec3 middle = paraboloid_direction((vec2(texel) + 0.5) / lookup.map_size * 2.0 - 1.0);
    vec3 normal = octahedral_decode(texelFetch(map_normals, ivec3(texel, map), 0).rg);
    float stored = texelFetch(depth_maps, ivec3(texel, map), 0).r * r.unit;
    float there = dot(normal, middle), here = dot(normal, r.direction) * sign(there);
    float compared = r.distance * (1.0 - lookup.map_bias) - r.unit / DEPTH_STEPS;
    return stored * abs(there) < compared * here; // else met behind the receiver, or never
}

float lit(int map, receiver r, float extent) {
    ivec2 texel = ivec2(r.uv * lookup.map_size);
    return texel_sees(map, r, texel) || !plane_hides(map, r, texel) ? 1.0 : 0.0;
}
#elif FILTER == FILTER_CSSM
// Convolution soft shadow maps by angles, as VALs have them [Dong 2009 §4.2].
#include "passes/visibility/cssm.glsl"

// A filter picks up the plane of a tilted receiver too, half of it nearer than the receiver. The step is no straight
// line, so the other half does not make up for that. The receiver is taken to be as near as the plane is at this share
// of the filter's width.
const float TILT = 0.125;

// The MIP level whose texel is half a filter of this width (a fraction of the map): a wider one picks
// up the tilted receiver itself.
float filter_lod(float width) {
    return max(0.0, log2(lookup.map_size * width) - 1.0);
}

float lit(int map, receiver r, float extent) {
    float d = r.distance / r.unit, radius = extent_in_units(r, extent);
    series_range range = series_range_at(map);
    float b = series_receiver(range, d, lookup.shift);
    // The first filter: the light's own solid angle seen from the receiver.
    float initial = light_angle(r, radius, d);
    float blocker = blocker_argument(basis_area(r.uv, filter_lod(angle_width(r, initial))), map, b);
    if (blocker < 0.0)
        return 1.0;
    float z_average = clamp(series_depth(range, blocker), 1e-3 * d, d);
    float alpha = atan(penumbra_angle(radius, d, z_average));
    b = series_receiver(range, d * (1.0 - min(TILT * alpha * receiver_slope(r), 0.5)), lookup.shift);
    float blocked = blocked_fraction(basis_area(r.uv, filter_lod(angle_width(r, alpha))), map, b);
    // Ringing suppression by shift and scale [Dong 2011, Fig. 5.2].
    return clamp(0.5 - (blocked - 0.5) * lookup.gain, 0.0, 1.0);
}
#elif FILTER == FILTER_PCSS
// Percentage-closer soft shadows [Fernando 2005; Dong 2011 §2.4.2]: the mean depth of what blocks within
// the light's own angle, then the blocked share within the penumbra. It reads many texels where convolution
// reads a few filtered ones, but needs no bases, no MIP maps and no expansion of the depth range: the way to
// go where visibility is looked up seldom.
#include "passes/visibility/depth_maps.glsl"

const float GOLDEN_ANGLE = 2.39996322972865;
const float ANGLE_MAX = 0.2; // radians: a wider filter leaves the plane that the receiver is taken for

// The texel of tap i of n: a spiral of equal areas in a disk around the receiver.
ivec2 tap_texel(receiver r, float radius, int i, int n) {
    float turn = float(i) * GOLDEN_ANGLE;
    vec2 at = r.uv + radius * (sqrt((float(i) + 0.5) / float(n)) * vec2(cos(turn), sin(turn)));
    return ivec2(at * lookup.map_size);
}

// What a tap meets beside a corner is the other wall, which hides nothing.
bool hides(int map, receiver r, ivec2 texel, float seen) {
    float met = seen_from_receiver(map, r, texel, seen);
    return receiver_distance(r, texel) > seen && met < r.distance * (1.0 - lookup.map_bias);
}

// The mean distance of what blocks; the receiver's where nothing does. Corners are asked for where a texel asked alone
// blocks, which is seldom. Loops end by a count and not by a branch: a software rasteriser leaves one that no pixel is in
// after one step.
float blocker_distance(int map, receiver r, float radius) {
    bool any = false;
    for (int i = 0; i < SEARCH_TAPS; i++)
        any = any || !texel_sees(map, r, tap_texel(r, radius, i, SEARCH_TAPS));
    float sum = 0.0, blockers = 0.0;
    int taps = any ? SEARCH_TAPS : 0;
    for (int i = 0; i < taps; i++) {
        ivec2 texel = tap_texel(r, radius, i, SEARCH_TAPS);
        float seen = seen_in(map, r, texel), blocks = hides(map, r, texel, seen) ? 1.0 : 0.0;
        sum += blocks * seen;
        blockers += blocks;
    }
    return blockers > 0.0 ? max(sum / blockers, 1e-3 * r.distance) : r.distance;
}

float hidden_share(int map, receiver r, float radius, bool wanted) {
    float sum = 0.0;
    int taps = wanted ? FILTER_TAPS : 0;
    for (int i = 0; i < taps; i++) {
        ivec2 texel = tap_texel(r, radius, i, FILTER_TAPS);
        sum += hides(map, r, texel, seen_in(map, r, texel)) ? 1.0 : 0.0;
    }
    return sum / float(FILTER_TAPS);
}

float lit(int map, receiver r, float extent) {
    float texel = 0.5 / lookup.map_size;
    // The search: half of the light's width, as an angle from its centre to the receiver.
    float angle = min(light_angle(r, extent, r.distance), ANGLE_MAX);
    float z = blocker_distance(map, r, max(0.5 * angle_width(r, angle), texel));
    angle = min(penumbra_angle(extent, r.distance, z), ANGLE_MAX);
    return 1.0 - hidden_share(map, r, max(0.5 * angle_width(r, angle), texel), z < r.distance);
}
#endif
