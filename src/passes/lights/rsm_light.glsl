// What a light sends where a texel of its view sees a surface, or by chance to a pane before it.
#include "lib/medium.glsl"
#include "lib/rsm.glsl"

struct rsm_light {
    surface s;
    vec3 power; // reflected, per solid angle, or per area of a directional light
    float cosine, distance2; // distance2 1: a directional light
    bool at_pane;
};

rsm_light rsm_light_at(light l, light_view view, ivec2 texel, uvec2 seed) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    surface s = rsm_surface(view, texel);
    vec3 seen = s.position, albedo = rsm_albedo(view, texel);
    vec3 direction = directional ? l.direction : normalize(s.position - l.position);
    vec3 arrives = medium_sends(l.position, direction, !directional, seed, s, albedo), from_light = s.position - l.position;
    float distance2 = directional ? 1.0 : dot(from_light, from_light);
    vec3 power = directional ? l.intensity : light_intensity(l, direction) * light_in_range(l, distance2);
    return rsm_light(s, albedo * power * arrives, -dot(s.normal, direction), distance2, s.position != seen);
}
