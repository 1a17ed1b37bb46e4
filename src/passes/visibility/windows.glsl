// Windows of a map, by its summed area table and its bounds.
//
// A filter that looks at windows falls into cells says what one adds:
//     struct cells                                          what is summed
//     cells cells_none()
//     void cells_add(inout cells c, cell k)
//     blocked cells_blocked(cells c)
// before filter_light_map.glsl uses them.
#include "passes/visibility/depth_maps.glsl"
#include "passes/visibility/sums.glsl"
#include "shared/maps.h"

layout(binding = UNIT_DEPTH_BOUNDS) uniform sampler2DArray depth_bounds;

const int SQUARES = 4;

// Squares of 2^(level + 1) texels, of which a window touches so many a side at most: the fewer, the more of what lies
// around it they have.
struct squares {
    ivec2 first, last;
    int base, level;
};

squares window_squares(vec4 window, int most) {
    ivec2 first = ivec2(window.xy * lookup.map_size), last = ivec2(window.zw * lookup.map_size), width = last - first;
    int base = int(lookup.map_size) / 2, level = findMSB(max(width.x, width.y) / (most - 1));
    level = clamp(level, 0, findMSB(base));
    return squares(first >> (level + 1), last >> (level + 1), base, level);
}

vec2 square_bounds(int map, squares q, ivec2 square) {
    ivec2 place = min(square, bounds_side(q.base, q.level) - 1) + ivec2(bounds_x(q.base, q.level), bounds_y(q.base, q.level));
    return texelFetch(depth_bounds, ivec3(place, map), 0).rg;
}

// Nearest and farthest of what is in the window, and maybe of some around it.
vec2 window_bounds(int map, vec4 window) {
    squares q = window_squares(window, SQUARES);
    vec2 found = vec2(1.0, 0.0);
    for (int i = 0; i < SQUARES * SQUARES; i++) {
        vec2 b = square_bounds(map, q, min(q.first + ivec2(i % SQUARES, i / SQUARES), q.last));
        found = vec2(min(found.x, b.x), max(found.y, b.y));
    }
    return found;
}

struct blocked {
    float share, depth; // of the window; map depth, the mean
};

// Map depth of the receiver's plane where it comes nearest to the light; no nearer than a share of the receiver's.
float plane_nearest_from(receiver r, vec4 window, float share) {
    vec2 corner = mix(window.xy, window.zw, greaterThan(r.slope, vec2(0.0)));
    return plane_depth_from(r, corner, share) / r.unit * (1.0 - lookup.map_bias);
}

float plane_nearest(receiver r, vec4 window) {
    return plane_nearest_from(r, window, 0.8);
}

// A cell of a window: whole texels, but at the rim, where it is as wide as a texel, a share of them.
struct cell {
    float area;  // texels
    float plane; // of the receiver, map depth
    vec4 mean;   // moments
    ivec3 texel; // in its middle
};

// Edge i of PARTS + 3 along one side: the outermost lie around the texels that the window cuts.
float cell_edge(float low, float high, int i, int parts) {
    float inner = clamp(round(mix(low, high, float(i - 1) / float(parts))), floor(low) + 1.0, floor(high));
    return i == 0 ? floor(low) : i == parts + 2 ? floor(high) + 1.0 : inner;
}

// What the window has of the cell before edge i.
float cell_width(float low, float high, float before, float edge) {
    return max(min(edge, high) - max(before, low), 0.0);
}

const float NEAREST = 0.2; // of the receiver's distance: what is nearer to the light counts as being there
const int PARTS_MAX = SEARCH_PARTS > SHADOW_PARTS ? SEARCH_PARTS : SHADOW_PARTS;

const int SEARCHES = 2;

// A box of the table must not have more than it can tell.
vec4 window_within(vec4 window, vec2 middle, int parts) {
    vec2 most = vec2(0.5 * float(parts * (SUM_BOX_MAX - 1)) / lookup.map_size);
    return vec4(max(window.xy, middle - most), min(window.zw, middle + most));
}

// Around the receiver 4 x 4 texels, of which the outer ones count by what a box of three has of them.
float contact_blocked(int map, receiver r, bool wanted) {
    vec2 at = r.uv * lookup.map_size - 0.5, base = floor(at), part = at - base;
    ivec2 end = ivec2(lookup.map_size) - 1;
    float sum = 0.0;
    int taps = wanted ? 16 : 0;
    for (int i = 0; i < taps; i++) {
        ivec2 k = ivec2(i & 3, i >> 2);
        vec2 weight = mix(mix(vec2(1.0), part, equal(k, ivec2(3))), 1.0 - part, equal(k, ivec2(0)));
        sum += texel_sees(map, r, clamp(ivec2(base) + k - 1, ivec2(0), end)) ? 0.0 : weight.x * weight.y;
    }
    return sum / 9.0;
}

// Where what hides the light may be: from the nearest that counts to the nearest of those in its window, and so on.
vec4 search_window(int map, receiver r, float extent, out float nearest) {
    float d = r.distance / r.unit;
    nearest = NEAREST * d;
    vec4 search = window_within(window(r, extent, nearest), r.uv, SEARCH_PARTS);
    for (int i = 0; i < SEARCHES; i++) {
        nearest = clamp(window_bounds(map, search).x, nearest, d);
        search = window_within(window(r, extent, nearest), r.uv, SEARCH_PARTS);
    }
    return search;
}

// Whether something in a square may hide the light: it lies before the receiver's plane, and within what ways to the light
// pass at its depth. The plane itself hides nothing, nor do the walls beside it.
bool square_blocks(int map, receiver r, float extent, squares q, ivec2 square) {
    float depth = max(square_bounds(map, q, square).x, NEAREST * r.distance / r.unit);
    vec4 around = vec4(square, square + 1) * (float(2 << q.level) / lookup.map_size);
    vec4 passed = window(r, extent, depth);
    return depth < plane_nearest_from(r, around, 0.5 * NEAREST) && all(lessThan(passed.xy, around.zw)) &&
           all(lessThan(around.xy, passed.zw));
}

// The same of a window: squares that may are looked at in parts.
bool window_blocks(int map, receiver r, float extent, vec4 window) {
    const int PARTS = 3; // of a side, as a power of two
    squares q = window_squares(window, 1 << PARTS), fine = q;
    fine.level = max(q.level - PARTS, 0);
    int parts = q.level - fine.level;
    bool found = false;
    for (int i = 0; i < 1 << (2 * PARTS) && !found; i++) {
        ivec2 square = q.first + ivec2(i & 7, i >> PARTS);
        if (any(greaterThan(square, q.last)) || !square_blocks(map, r, extent, q, square))
            continue;
        for (int k = 0; k < 1 << (2 * parts) && !found; k++)
            found = square_blocks(map, r, extent, fine, (square << parts) + ivec2(k & ((1 << parts) - 1), k >> parts));
    }
    return found;
}
