// The triangle that a pixel sees, as its neighbours' depths tell, for what its smooth normal does not: a triangle that is
// turned away from a light hides itself, as paths find. Lookups in maps begin too far above the surface to see that, and
// what is round would be lit behind its horizon.
#include "lib/gbuffer.glsl"

// Depth is linear across a plane (shared/view.h): its differences to both sides are the same, but for so much.
const float FACET_BENT = 0.2;
// What a normal map bends is no farther from its triangle.
const float FACET_COSINE = 0.1;
// What lies on the triangle itself, or on the next one, is on either side of its plane by what places are rounded.
const float FACET_HORIZON = 0.005;

float depth_beside(ivec2 pixel, ivec2 step) {
    return gbuffer_depth(clamp(pixel + step, ivec2(0), gbuffer_size() - 1));
}

// The normal, of any length, of the plane that has this depth at `ndc`, and that slope over ndc: along the camera's axes
// places are z (forward + x right + y up), where near / z is the depth, linear in x and y; of an orthographic one z is.
// right, up and forward here are the dual axes.
vec3 plane_normal(vec2 ndc, float depth, vec2 slope) {
    vec3 axis = view_axis(camera), forward = axis / dot(axis, axis), lean = camera.forward - axis;
    vec3 right = camera.right / dot(camera.right, camera.right), up = camera.up / dot(camera.up, camera.up);
    right -= dot(right, lean) * axis;
    up -= dot(up, lean) * axis;
    return camera.orthographic ? forward + camera.far * (slope.x * right + slope.y * up)
                               : (depth - dot(slope, ndc)) * forward + slope.x * right + slope.y * up;
}

// Its normal; the surface's own where the neighbours do not tell.
vec3 facet_of(surface s, ivec2 pixel) {
    vec2 size = vec2(gbuffer_size());
    float depth = gbuffer_depth(pixel);
    vec2 before = depth - vec2(depth_beside(pixel, ivec2(-1, 0)), depth_beside(pixel, ivec2(0, -1)));
    vec2 after = vec2(depth_beside(pixel, ivec2(1, 0)), depth_beside(pixel, ivec2(0, 1))) - depth;
    bool known = all(lessThan(abs(before - after), FACET_BENT * min(abs(before), abs(after)) + 1e-4 * depth));
    vec3 facet = plane_normal((vec2(pixel) + 0.5) / size * 2.0 - 1.0, depth, 0.25 * size * (before + after));
    float cosine = dot(facet, s.normal);
    float inverse_length = inversesqrt(max(dot(facet, facet), 1e-30)) * sign(cosine);
    return known && abs(cosine * inverse_length) > FACET_COSINE ? facet * inverse_length : s.normal;
}

// How far near light lies above the triangle's plane: from 0 in it to 1 at 7 degrees. A bent normal faces places in the plane,
// and so do those of the triangle's other side.
float above_horizon(vec3 facet, vec3 to_light) {
    const float STEEP = 8.0;
    return clamp(STEEP * dot(facet, to_light) * inversesqrt(max(dot(to_light, to_light), 1e-30)), 0.0, 1.0);
}

// Whether the triangle of that normal is turned away from what lies there.
bool is_behind_horizon(vec3 facet, vec3 to_light) {
    return dot(facet, to_light) < -FACET_HORIZON * length(to_light);
}
