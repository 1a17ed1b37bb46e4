// All that a tap of the blur reads, in one texel of 128 bits: a software rasteriser pays for each fetch.
#include "lib/octahedral.glsl"

struct blur_tap {
    float depth; // reversed, as in the G-buffer; 0 where nothing is
    vec2 normal_code;
    vec3 irradiance;
    bool detail; // of many lights, and blurred little
};

// 21 bits of each float: all of its exponent, 13 of its fraction. The bit that is left is `detail`.
const uint DETAIL_BIT = 0x200000u;

uvec4 blur_tap_pack(blur_tap tap) {
    uvec3 rgb = floatBitsToUint(max(tap.irradiance, 0.0)) + 512u >> 10;
    return uvec4(floatBitsToUint(tap.depth), packUnorm2x16(tap.normal_code),
                 rgb.r << 11 | rgb.g >> 10, rgb.g << 22 | (tap.detail ? DETAIL_BIT : 0u) | rgb.b);
}

float blur_tap_depth(uvec4 tap) {
    return uintBitsToFloat(tap.x);
}

vec3 blur_tap_normal(uvec4 tap) {
    return octahedral_decode(unpackUnorm2x16(tap.y));
}

bool blur_tap_detail(uvec4 tap) {
    return (tap.w & DETAIL_BIT) != 0u;
}

vec3 blur_tap_irradiance(uvec4 tap) {
    uvec3 rgb = uvec3(tap.z >> 11, (tap.z & 0x7ffu) << 10 | tap.w >> 22, tap.w & 0x1fffffu);
    return uintBitsToFloat(rgb << 10);
}
