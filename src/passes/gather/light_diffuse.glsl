// What a surface receives of a light: irradiance times pi.
#include "passes/gather/emission.glsl"
#include "passes/gather/geometry_term.glsl"
#include "lib/medium.glsl"

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
