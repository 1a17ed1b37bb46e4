// The filter of lights' own maps, by FILTER (shared/maps.h).
#if FILTER == FILTER_VSSM
// Variance soft shadow maps [Dong 2011 ch. 7]: of what lies in a window mean and variance bound the part that is farther
// than the receiver, by Chebyshev's inequality. It says nothing where the mean is farther: windows fall into cells, those
// with a nearer mean are taken together, in the others a texel is compared.
#include "passes/visibility/windows.glsl"

// Depths count from the receiver's own plane towards the light, so that one that is tilted does not shadow itself.
struct cells {
    float area;
    float pooled, above, above2, plane; // area of cells with a nearer mean; over it, sums of height, its square, the plane
    float compared, depth;              // blocked area of the others, and over it the sum of depths
};

const float VARIANCE_MIN = 1e-9; // a cell of less has one depth

cells cells_none() {
    return cells(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
}

void cells_add(inout cells c, cell k) {
    float above = k.plane - k.mean.x, variance = max(k.mean.y - k.mean.x * k.mean.x, 0.0);
    float stored = texelFetch(depth_maps, k.texel, 0).r;
    bool pooled = above > 0.0, compared = !pooled && variance > VARIANCE_MIN && stored < k.plane;
    float area = pooled ? k.area : 0.0;
    c.area += k.area;
    c.pooled += area;
    c.above += area * above;
    c.above2 += area * (variance + above * above);
    c.plane += area * k.plane;
    c.compared += compared ? k.area : 0.0;
    c.depth += compared ? k.area * stored : 0.0;
}

// What does not block is taken to lie in the receiver's plane (eq. 7.4): then the share of blockers is mean^2 / mean
// square of heights, theirs the mean square over the mean, and their sum that of all.
blocked cells_blocked(cells c) {
    float pooled = c.above * c.above / max(c.above2, 1e-30);
    float area = pooled + c.compared, depth = pooled * c.plane / max(c.pooled, 1e-30) - c.above + c.depth;
    return blocked(area / max(c.area, 1e-30), depth / max(area, 1e-30));
}
#elif FILTER == FILTER_MSM
// Moment soft shadow maps [Peters and Klein 2015; Peters et al. 2017]: of all distributions with the four moments of what
// lies in a window, the least part that is nearer than the receiver. Exact where that is two depths.
#include "passes/visibility/windows.glsl"

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
#else
// Convolution soft shadow maps by windows [Dong 2011 ch. 5]: MIP levels that are as wide, or boxes of summed area tables.
#include "passes/visibility/cssm.glsl"
#include "passes/visibility/windows.glsl"

// A window picks up the plane of a tilted receiver too, half of it nearer than the receiver: that is taken to be as near
// as the plane is so far along the way to the window's nearest corner. A texel of a level, and what is between two, reaches
// beyond the window; a box does not.
#ifdef BASIS_SUMS
const float TILT = 1.0;
#else
const float TILT = 2.0;
#endif

float lit(int map, receiver r, float extent) {
    float d = r.distance / r.unit, nearest;
    series_range range = series_range_at(map);
    vec4 search = search_window(map, r, extent, nearest);
    float b = series_receiver(range, mix(d, plane_nearest(r, search), TILT), lookup.shift);
    float argument = blocker_argument(basis_area_of(search), map, b);
    bool hidden = argument >= 0.0 && nearest < d * (1.0 - lookup.map_bias) && window_blocks(map, r, extent, search);
    float z = hidden ? clamp(series_depth(range, argument), nearest, d) : d;
    bool contact = hidden && d - z < lookup.contact * d;
    vec4 penumbra = window_within(window(r, extent, z), r.uv, SHADOW_PARTS);
    b = series_receiver(range, mix(d, plane_nearest(r, penumbra), TILT), lookup.shift);
    float blocked = blocked_fraction(basis_area_of(penumbra), map, b);
    // Shares between stay as they are, ringing lies outside.
    float share = clamp(1.0 - blocked * lookup.gain, 0.0, 1.0);
    float close = contact_blocked(map, r, contact);
    return contact ? 1.0 - close : hidden ? share : 1.0;
}
#endif

#if FILTER == FILTER_VSSM || FILTER == FILTER_MSM
// Whether what stands before the receiver in a cell lies beside all ways to the light: of what is behind it the map
// knows nothing. One depth in front and the receiver's own are told by two moments.
bool hides_nothing(receiver r, float extent, cell k, vec4 box) {
    float above = k.plane - k.mean.x, above2 = k.mean.y + k.plane * (k.plane - 2.0 * k.mean.x);
    vec4 ways = window(r, extent, max(k.plane - above2 / max(above, 1e-6), NEAREST * k.plane));
    return above > 0.0 && (any(lessThan(box.zw, ways.xy)) || any(greaterThan(box.xy, ways.zw)));
}

// The cells of a window, one after another, from a summed area table: each corner of the grid is fetched once.
cells window_cells(int map, receiver r, float extent, vec4 window, int parts, bool seeks, bool wanted) {
    vec2 high = min(window.zw * lookup.map_size, lookup.map_size - 0.01);
    vec2 low = min(window.xy * lookup.map_size, high - 1.0);
    cells c = cells_none();
    uvec4 below[PARTS_MAX + 3];
    vec2 before, edge;
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in after one step.
    int corners = wanted ? parts + 3 : 0;
    edge.y = 0.0;
    for (int j = 0; j < corners; j++) {
        before.y = edge.y;
        edge.y = cell_edge(low.y, high.y, j, parts);
        uvec4 left = uvec4(0u), below_left = uvec4(0u);
        edge.x = 0.0;
        for (int i = 0; i < corners; i++) {
            before.x = edge.x;
            edge.x = cell_edge(low.x, high.x, i, parts);
            uvec4 corner = texelFetch(sums, ivec3(edge, map), 0), under = j > 0 ? below[i] : uvec4(0u);
            vec2 texels = edge - before;
            if (i > 0 && j > 0 && texels.x * texels.y > 0.0) {
                cell k;
                vec2 middle = 0.5 * (before + edge);
                k.area = cell_width(low.x, high.x, before.x, edge.x) * cell_width(low.y, high.y, before.y, edge.y);
                vec4 box = vec4(before, edge) / lookup.map_size;
                // A search rather finds the receiver itself, which the window that follows tells, than misses casters.
                k.plane = plane_nearest(r, seeks ? clamp(r.uv, box.xy, box.zw).xyxy : box);
                k.mean = vec4(corner - left - under + below_left) / (texels.x * texels.y * SUM_ONE);
                k.texel = ivec3(middle, map);
                if (!hides_nothing(r, extent, k, box))
                    cells_add(c, k);
            }
            below[i] = corner;
            left = corner;
            below_left = under;
        }
    }
    return c;
}

// Soft shadows from windows: how deep what blocks lies, sought where ways to the light may pass it, then its share
// where they do [Fernando 2005; Dong 2011 §7.3].

const float LIT = 1e-3;     // so little blocked is nothing

float lit(int map, receiver r, float extent) {
    float d = r.distance / r.unit, compared = d * (1.0 - lookup.map_bias);
    float nearest;
    vec4 search = search_window(map, r, extent, nearest);
    blocked found = cells_blocked(window_cells(map, r, extent, search, SEARCH_PARTS, true, nearest < compared));
    bool hidden = found.share > LIT;
    float z = clamp(found.depth, nearest, d);
    bool contact = hidden && d - z < lookup.contact * d;
    vec4 penumbra = window_within(window(r, extent, z), r.uv, SHADOW_PARTS);
    bool dark = hidden && !contact && window_bounds(map, penumbra).y < plane_nearest(r, penumbra);
    bool partly = hidden && !contact && !dark;
    float share = cells_blocked(window_cells(map, r, extent, penumbra, SHADOW_PARTS, false, partly)).share;
    return 1.0 - (contact ? contact_blocked(map, r, contact) : partly ? share : dark ? 1.0 : 0.0);
}
#endif
