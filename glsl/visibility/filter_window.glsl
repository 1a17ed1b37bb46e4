// Soft shadows from windows: how deep what blocks lies, sought where ways to the light may pass it, then its share
// where they do [Fernando 2005; Dong 2011 §7.3].

const int SEARCHES = 2;
const float LIT = 1e-3;     // so little blocked is nothing

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

float lit(int map, receiver r, float extent) {
    float d = r.distance / r.unit, compared = d * (1.0 - lookup.map_bias);
    float nearest = NEAREST * d;
    vec4 search = window_within(window(r, extent, nearest), r.uv, SEARCH_PARTS);
    // From the nearest that counts to the nearest of those in its window, and so on.
    for (int i = 0; i < SEARCHES; i++) {
        nearest = clamp(window_bounds(map, search).x, nearest, d);
        search = window_within(window(r, extent, nearest), r.uv, SEARCH_PARTS);
    }
    blocked found = cells_blocked(window_cells(map, r, extent, search, SEARCH_PARTS, nearest < compared));
    bool hidden = found.share > LIT;
    float z = clamp(found.depth, nearest, d);
    bool contact = hidden && d - z < lookup.contact * d;
    vec4 penumbra = window_within(window(r, extent, z), r.uv, SHADOW_PARTS);
    bool dark = hidden && !contact && window_bounds(map, penumbra).y < plane_nearest(r, penumbra);
    bool partly = hidden && !contact && !dark;
    float share = cells_blocked(window_cells(map, r, extent, penumbra, SHADOW_PARTS, partly)).share;
    return 1.0 - (contact ? contact_blocked(map, r, contact) : partly ? share : dark ? 1.0 : 0.0);
}
