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
