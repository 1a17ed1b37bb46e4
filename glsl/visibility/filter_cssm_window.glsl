// Convolution soft shadow maps by windows [Dong 2011 ch. 5]: MIP levels that are as wide, or boxes of summed area tables.
#include "visibility/cssm.glsl"
#include "visibility/windows.glsl"

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
