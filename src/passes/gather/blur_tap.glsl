// All that a tap of the blur reads, in one texel of 128 bits: a software rasteriser pays for each fetch, and for what
// it takes to unpack it.
struct blur_tap {
    float depth;  // along the view's axis, metres; 0 where nothing is
    uint normal;  // blur_tap_normal_code
    vec3 irradiance;
    int level;    // BLUR_LEVEL_...
};

// 21 bits of each float: all of its exponent, 13 of its fraction.
uvec4 blur_tap_lit(uvec4 tap, vec3 irradiance) {
    uvec3 rgb = floatBitsToUint(max(irradiance, 0.0)) + 512u >> 10;
    return uvec4(tap.xy, rgb.r << 11 | rgb.g >> 10, rgb.g << 22 | rgb.b);
}

uvec4 blur_tap_pack(blur_tap tap) {
    uvec2 place = uvec2(floatBitsToUint(tap.depth), tap.normal | uint(tap.level) << 30);
    return blur_tap_lit(uvec4(place, 0u, 0u), tap.irradiance);
}

float blur_tap_depth(uvec4 tap) {
    return uintBitsToFloat(tap.x);
}

// Ten bits each, as no more than their angle is asked for.
uint blur_tap_normal_code(vec3 normal) {
    uvec3 code = uvec3(normal * 511.0 + 512.5);
    return code.x | code.y << 10 | code.z << 20;
}

vec3 blur_tap_normal(uvec4 tap) {
    return vec3(ivec3(tap.yyy >> uvec3(0u, 10u, 20u) & 0x3ffu) - 512) / 511.0;
}

int blur_tap_level(uvec4 tap) {
    return int(tap.y >> 30);
}

vec3 blur_tap_irradiance(uvec4 tap) {
    uvec3 rgb = uvec3(tap.z >> 11, (tap.z & 0x7ffu) << 10 | tap.w >> 22, tap.w & 0x1fffffu);
    return uintBitsToFloat(rgb << 10);
}

#if SPECULAR_BLUR
#include "lib/gbuffer_specular.glsl"
#include "lib/lobe_albedo.glsl"

// Directional albedo of a pixel's specular part. The blur divides radiance by it, so that textures stay sharp.
vec3 pixel_reflects(ivec2 pixel) {
    specular_surface s = gbuffer_specular(gbuffer_surface(pixel), pixel);
    return max(specular_albedo(s.f0, s.f90, s.alpha, dot(s.normal, s.to_eye)), 1e-3);
}
#endif
