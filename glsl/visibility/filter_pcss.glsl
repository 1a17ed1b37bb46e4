// Percentage-closer soft shadows [Fernando 2005; Dong 2011 §2.4.2]: the mean depth of what blocks within
// the light's own angle, then the blocked share within the penumbra. It reads many texels where convolution
// reads a few filtered ones, but needs no bases, no MIP maps and no expansion of the depth range: the way to
// go where visibility is looked up seldom.
#include "visibility/depth_maps.glsl"

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
