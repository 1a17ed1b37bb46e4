// Percentage-closer soft shadows [Fernando 2005; Dong 2011 §2.4.2]: the mean depth of what blocks within
// the light's own angle, then the blocked share within the penumbra. It reads many texels where convolution
// reads a few filtered ones, but needs no bases, no MIP maps and no expansion of the depth range: the way to
// go where visibility is looked up seldom.
#include "visibility/depth_maps.glsl"

const float GOLDEN_ANGLE = 2.39996322972865;
const float ANGLE_MAX = 0.2; // radians: a wider filter leaves the plane that the receiver is taken for

// Tap i of n: a spiral of equal areas in the unit disk.
vec2 spiral(int i, int n) {
    float turn = float(i) * GOLDEN_ANGLE;
    return sqrt((float(i) + 0.5) / float(n)) * vec2(cos(turn), sin(turn));
}

float lit(int map, receiver r, float extent) {
    float texel = 0.5 / lookup.map_size;
    // The search: half of the light's width, as an angle from its centre to the receiver.
    float angle = min(light_angle(r, extent, r.distance), ANGLE_MAX);
    float search = max(0.5 * angle_width(r, angle), texel);
    float depth_sum = 0.0, blockers = 0.0;
    for (int i = 0; i < SEARCH_TAPS; i++) {
        vec2 at = r.uv + search * spiral(i, SEARCH_TAPS);
        if (!texel_sees(map, r, ivec2(at * lookup.map_size))) {
            depth_sum += map_depth(r, texture(depth_maps, vec3(at, map)).r);
            blockers += 1.0;
        }
    }
    float z = blockers > 0.0 ? max(depth_sum / blockers * r.unit, 1e-3 * r.distance) : r.distance;
    angle = min(penumbra_angle(extent, r.distance, z), ANGLE_MAX);
    float width = max(0.5 * angle_width(r, angle), texel);
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in after one step.
    int taps = blockers > 0.0 ? FILTER_TAPS : 0;
    float sum = 0.0;
    for (int i = 0; i < taps; i++) {
        vec2 at = r.uv + width * spiral(i, FILTER_TAPS);
        sum += texel_sees(map, r, ivec2(at * lookup.map_size)) ? 1.0 : 0.0;
    }
    return taps > 0 ? sum / float(FILTER_TAPS) : 1.0;
}
