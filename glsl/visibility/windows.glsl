// Windows of a map, by its summed area table and its bounds.
//
// A filter that looks at windows falls into cells says what one adds:
//     struct cells                                          what is summed
//     cells cells_none()
//     void cells_add(inout cells c, cell k)
//     blocked cells_blocked(cells c)
// before it includes filter_window.glsl.
#include "shared/depth_bounds.h"
#include "visibility/depth_maps.glsl"
#include "visibility/sums.glsl"

layout(binding = UNIT_DEPTH_BOUNDS) uniform sampler2DArray depth_bounds;

const int SQUARES = 4;

vec2 square_bounds(int map, int level, int base, ivec2 square) {
    ivec2 place = min(square, bounds_side(base, level) - 1) + ivec2(bounds_x(base, level), bounds_y(base, level));
    return texelFetch(depth_bounds, ivec3(place, map), 0).rg;
}

// Nearest and farthest of what is in the window, and maybe of some around it.
vec2 window_bounds(int map, vec4 window) {
    ivec2 first = ivec2(window.xy * lookup.map_size), last = ivec2(window.zw * lookup.map_size), width = last - first;
    // Squares of 2^(level + 1) texels, of which the window touches SQUARES a side at most: the fewer, the more of what
    // lies around it they have.
    int base = int(lookup.map_size) / 2, level = findMSB(max(width.x, width.y) / (SQUARES - 1));
    level = clamp(level, 0, findMSB(base));
    vec2 found = vec2(1.0, 0.0);
    for (int i = 0; i < SQUARES * SQUARES; i++) {
        ivec2 square = min((first >> (level + 1)) + ivec2(i % SQUARES, i / SQUARES), last >> (level + 1));
        vec2 b = square_bounds(map, level, base, square);
        found = vec2(min(found.x, b.x), max(found.y, b.y));
    }
    return found;
}

struct blocked {
    float share, depth; // of the window; map depth, the mean
};

// Map depth of the receiver's plane where it comes nearest to the light.
float plane_nearest(receiver r, vec4 window) {
    vec2 corner = mix(window.xy, window.zw, greaterThan(r.slope, vec2(0.0)));
    return plane_depth(r, corner) / r.unit * (1.0 - lookup.map_bias);
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
