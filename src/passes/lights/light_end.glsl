// What rays of light meet: the albedo of a triangle, and where light ends that is sent along a direction.
#include "lib/medium.glsl"

// What a surface reflects that a ray meets, by two texels of its triangle: the albedo's square root, A: 1 where backs reflect,
// too; and the specular part of it (lib/brdf.glsl).
layout(binding = UNIT_TRIANGLE_ALBEDOS) uniform samplerBuffer albedos;

vec3 reflected(bvh_hit hit) {
    vec4 code = texelFetch(albedos, 2 * hit.triangle);
    return code.rgb * code.rgb * (hit.back ? code.a : 1.0);
}

vec4 reflected_specular(bvh_hit hit) {
    bool reflects = !hit.back || texelFetch(albedos, 2 * hit.triangle).a > 0.0;
    return reflects ? texelFetch(albedos, 2 * hit.triangle + 1) : vec4(0.0);
}

// Where light ends that is sent along a unit direction: on a surface, or by chance on a pane before it. albedo: what
// the end reflects; specular: the lobe's part of it (lib/brdf.glsl); arrives: what of the light arrives, over the chance;
// away: of the surface, metres.
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
