// Convolution soft shadow maps by windows [Dong 2011 ch. 5]: MIP levels that are as wide.
#include "visibility/cssm.glsl"
#include "visibility/windows.glsl"

// A window picks up the plane of a tilted receiver too, half of it nearer than the receiver: that is taken to be as near
// as the plane is so far along the way to the window's nearest corner: a texel of a level, and what is between two, reaches
// beyond the window.
const float TILT = 2.0;

// The level whose texel is so much narrower than the window that what is between two texels comes out right.
float window_lod(vec4 window) {
    vec2 texels = (window.zw - window.xy) * lookup.map_size;
    return max(0.5 * log2(texels.x * texels.y) - 0.5, 0.0);
}

float lit(int map, receiver r, float extent) {
    float d = r.distance / r.unit, nearest;
    series_range range = series_range_at(map);
    vec4 search = search_window(map, r, extent, nearest);
    float b = series_receiver(range, mix(d, plane_nearest(r, search), TILT), lookup.shift);
    float argument = blocker_argument(0.5 * (search.xy + search.zw), map, b, window_lod(search));
    bool hidden = argument >= 0.0 && nearest < d * (1.0 - lookup.map_bias);
    float z = hidden ? clamp(series_depth(range, argument), nearest, d) : d;
    bool contact = hidden && d - z < lookup.contact * d;
    vec4 penumbra = window(r, extent, z);
    b = series_receiver(range, mix(d, plane_nearest(r, penumbra), TILT), lookup.shift);
    float blocked = blocked_fraction(0.5 * (penumbra.xy + penumbra.zw), map, b, window_lod(penumbra));
    // Shares between stay as they are, ringing lies outside.
    float share = clamp(1.0 - blocked * lookup.gain, 0.0, 1.0);
    float close = contact_blocked(map, r, contact);
    return contact ? 1.0 - close : hidden ? share : 1.0;
}
