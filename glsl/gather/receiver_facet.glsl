// The triangle that a pixel sees, as its neighbours' depths tell, for what its smooth normal does not: a triangle that is
// turned away from a light hides itself, as paths find. Lookups in maps begin too far above the surface to see that, and
// what is round would be lit behind its horizon.
#include "lib/gbuffer.glsl"

// Depth is linear across a plane (shared/view.h): its differences to both sides are the same, but for so much.
const float FACET_BENT = 0.2;
// A facet and a smooth surface are no farther apart.
const float FACET_COSINE = 0.7;

vec3 position_of(ivec2 pixel, ivec2 size) {
    return view_position(camera, (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0, gbuffer_depth(pixel));
}

bool is_straight(ivec2 pixel, ivec2 step, ivec2 size, float depth) {
    float before = depth - gbuffer_depth(max(pixel - step, ivec2(0)));
    float after = gbuffer_depth(min(pixel + step, size - 1)) - depth;
    return abs(before - after) < FACET_BENT * min(abs(before), abs(after)) + 1e-4 * depth;
}

// Its normal, of any length; the surface's own where the neighbours do not tell.
vec3 facet_of(surface s, ivec2 pixel) {
    ivec2 size = gbuffer_size();
    float depth = gbuffer_depth(pixel);
    vec3 right = position_of(pixel + ivec2(1, 0), size) - s.position;
    vec3 up = position_of(pixel + ivec2(0, 1), size) - s.position;
    vec3 facet = cross(right, up);
    float cosine = dot(facet, s.normal);
    bool known = is_straight(pixel, ivec2(1, 0), size, depth) && is_straight(pixel, ivec2(0, 1), size, depth);
    return known && abs(cosine) > FACET_COSINE * length(facet) ? facet * sign(cosine) : s.normal;
}
