// A texel of the light's view as the near field reads it, in 128 bits: one fetch a sample.
#include "lib/octahedral.glsl"

struct near_light {
    float z;          // along the view's axis, metres; 0 where nothing is
    vec2 normal_code;
    vec3 power;       // reflected per ndc area and spread of the view, times params.power_scale
    float spacing;    // of the VPLs here, over the scene's radius
};

uvec4 near_light_pack(near_light light) {
    return uvec4(floatBitsToUint(light.z), packUnorm2x16(light.normal_code),
                 packHalf2x16(light.power.rg), packHalf2x16(vec2(light.power.b, light.spacing)));
}

near_light near_light_unpack(uvec4 code) {
    vec2 rest = unpackHalf2x16(code.w);
    return near_light(uintBitsToFloat(code.x), unpackUnorm2x16(code.y),
                      vec3(unpackHalf2x16(code.z), rest.x), rest.y);
}
