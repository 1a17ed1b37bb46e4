// All that a tap of the blur reads, in one texel of 128 bits: a software rasteriser pays for each fetch.
#include "lib/octahedral.glsl"

struct blur_tap {
    float depth; // reversed, as in the G-buffer; 0 where nothing is
    vec2 normal_code;
    vec3 irradiance;
};

uvec4 blur_tap_pack(blur_tap tap) {
    return uvec4(floatBitsToUint(tap.depth), packUnorm2x16(tap.normal_code),
                 packHalf2x16(tap.irradiance.rg), packHalf2x16(vec2(tap.irradiance.b, 0.0)));
}

float blur_tap_depth(uvec4 tap) {
    return uintBitsToFloat(tap.x);
}

vec3 blur_tap_normal(uvec4 tap) {
    return octahedral_decode(unpackUnorm2x16(tap.y));
}

vec3 blur_tap_irradiance(uvec4 tap) {
    return vec3(unpackHalf2x16(tap.z), unpackHalf2x16(tap.w).x);
}
