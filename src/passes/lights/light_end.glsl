// Where light ends that is sent along a unit direction: on a surface, or by chance on a pane before it.
#include "lib/medium.glsl"
#include "passes/lights/triangle_albedo.glsl"

// albedo: what the end reflects; specular: the lobe's part of it (lib/specular.glsl); arrives: what of the light arrives, over
// the chance; away: of the surface, metres.
surface light_end(vec3 from, vec3 direction, uvec2 seed, out vec3 albedo, out vec4 specular, out vec3 arrives,
                  out float away) {
    bvh_hit hit = bvh_meet(from, direction, true);
    vec3 place = from + hit.distance * direction;
    surface s = surface(hit.triangle >= 0, place, hit.normal);
    albedo = reflected(hit);
    arrives = medium_sends(from, direction, true, seed, s, albedo);
    specular = s.position == place ? reflected_specular(hit) : vec4(0.0);
    away = hit.distance;
    return s;
}
