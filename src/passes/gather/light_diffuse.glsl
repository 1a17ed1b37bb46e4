// What a surface receives of a light: irradiance times pi.
#include "lib/medium.glsl"
#include "passes/gather/geometry_term.glsl"

// How brightly a VPL shines towards a point, over what it would if it emitted evenly. Its lobe mirrors its light [Walter et
// al. 2007], and is as wide as the patch that the VPL stands for is from there [Hašan et al. 2009].
#ifdef VPL_LOBES
#include "lib/brdf.glsl"
#include "lib/direction.glsl"

// Spots of narrower lobes would be seen one by one, and wider ones than that would have another albedo.
const float LOBE_ALPHA_MIN = 0.2, LOBE_ALPHA_MAX = 0.3;

float emission_towards(vpl light, vec3 to_light) {
    float distance2 = max(dot(to_light, to_light), 1e-30);
    float alpha = sqrt(light.alpha * light.alpha + light.area / distance2);
    alpha = clamp(alpha, LOBE_ALPHA_MIN, max(light.alpha, LOBE_ALPHA_MAX));
    vec3 direction = -to_light * inversesqrt(distance2), to_eye = octahedral_decode(light.to_light);
    specular_surface lobe = specular_surface(vec3(1.0), vec3(1.0), alpha, light.normal, facing(light.normal, to_eye));
    vec2 share_and_albedo = unpackHalf2x16(floatBitsToUint(light.lobe));
    float even = max(dot(light.normal, direction), 1e-4) * max(share_and_albedo.y, 1e-3);
    return mix(1.0, 3.14159265359 * specular_brdf(lobe, direction).r / even, share_and_albedo.x);
}
#else
float emission_towards(vpl light, vec3 to_light) {
    return 1.0;
}
#endif

#if CLAMP == GATHER_CLAMP_PATCH
layout(binding = UNIT_PATHS_KEPT) uniform sampler2D paths_kept;

// Times what patches keep of all light.
float given_back() {
    return 1.0 / texelFetch(paths_kept, ivec2(0), 0).r;
}
#else
float given_back() {
    return 1.0;
}
#endif

int lights_per_test(int most) {
    return most;
}

bool receives_light(surface s, ivec2 pixel) {
    return true;
}

vec3 unshadowed(int i, vpl light, surface s, out vec3 back) {
    vec3 to_light = light.position - s.position;
    bool is_behind = TERM_OF_POINT && is_behind_horizon(receiver_facet, to_light);
    back = vec3(0.0);
    vec3 flux = light.flux * medium_passes_between(s.position, light.position);
    return flux * (is_behind ? 0.0 : light_term(i, to_light, s.normal, light) * emission_towards(light, to_light));
}

vec3 arriving(vec3 own, vec3 back, float visible) {
    return own * visible;
}
