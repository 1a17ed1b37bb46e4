// Moment soft shadow maps [Peters and Klein 2015; Peters et al. 2017]: of all distributions with the four moments of what
// lies in a window, the least part that is nearer than the receiver. Exact where that is two depths.
#include "visibility/windows.glsl"

// Moments of the height above the receiver's own plane, towards the light.
struct cells {
    float area, plane; // the sum of planes
    vec4 heights;      // of powers
};

cells cells_none() {
    return cells(0.0, 0.0, vec4(0.0));
}

void cells_add(inout cells c, cell k) {
    float p = k.plane, p2 = p * p;
    vec4 m = k.mean;
    vec4 heights = vec4(p - m.x, p2 - 2.0 * p * m.x + m.y, p2 * p - 3.0 * p2 * m.x + 3.0 * p * m.y - m.z,
                        p2 * p2 - 4.0 * p2 * p * m.x + 6.0 * p2 * m.y - 4.0 * p * m.z + m.w);
    c.area += k.area;
    c.plane += k.area * p;
    c.heights += k.area * heights;
}

const float MOMENT_BIAS = 3e-5; // towards heights that are even in [-1, 1]: rounded moments may be nobody's

// The part of heights above 0, and their mean, from moments of heights in [-1, 1].
vec2 above_plane(vec4 b) {
    b = mix(b, vec4(0.0, 1.0 / 3.0, 0.0, 1.0 / 5.0), MOMENT_BIAS);
    float d2 = b.y - b.x * b.x, l32 = (b.z - b.x * b.y) / d2;
    float d3 = max(b.w - b.y * b.y - l32 * l32 * d2, 1e-12);
    float c3 = (l32 * b.x - b.y) / d3, c2 = -b.x / d2 - l32 * c3, c1 = 1.0 - b.x * c2 - b.y * c3;
    // The two other heights of the distribution that has one in the plane.
    float p = c2 / c3, q = c1 / c3, root = sqrt(max(0.25 * p * p - q, 0.0));
    float low = -0.5 * p - root, high = -0.5 * p + root;
    float low_weight = (b.y - b.x * high) / (low * (low - high)), high_weight = (b.y - b.x * low) / (high * (high - low));
    vec2 above = vec2(0.0);
    above += low > 0.0 ? low_weight * vec2(1.0, low) : vec2(0.0);
    above += high > 0.0 ? high_weight * vec2(1.0, high) : vec2(0.0);
    return vec2(clamp(above.x, 0.0, 1.0), above.x > 0.0 ? above.y / above.x : 0.0);
}

blocked cells_blocked(cells c) {
    vec4 b = c.heights / max(c.area, 1e-20);
    float scale = max(2.0 * sqrt(max(b.y, 0.0)), 1e-4);
    vec2 above = above_plane(b / vec4(scale, scale * scale, scale * scale * scale, scale * scale * scale * scale));
    return blocked(above.x, c.plane / max(c.area, 1e-20) - above.y * scale);
}

#include "visibility/filter_cells.glsl"
#include "visibility/filter_window.glsl"
