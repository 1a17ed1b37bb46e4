// The lights' views as the near field reads them: 128 bits a texel, one fetch a sample.
#include "lib/direction.glsl"
#include "lib/light.glsl"
#include "shared/gather.h"

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

layout(binding = UNIT_NEAR_LIGHT) uniform usampler2DArray near_lights[LIGHT_MAP_KINDS];

// Of maps of the kind, texels a side.
int near_size(int kind) {
    return kind == LIGHT_MAP_FACE ? textureSize(near_lights[LIGHT_MAP_FACE], 0).x
                                  : textureSize(near_lights[LIGHT_MAP_SINGLE], 0).x;
}

near_light near_fetch(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return near_light_unpack(v.kind == LIGHT_MAP_FACE
                                 ? texelFetch(near_lights[LIGHT_MAP_FACE], place, 0)
                                 : texelFetch(near_lights[LIGHT_MAP_SINGLE], place, 0));
}

// Returns the texel that holds the point.
ivec2 near_texel(vec2 ndc, int size) {
    return clamp(ivec2((ndc * 0.5 + 0.5) * float(size)), ivec2(0), ivec2(size - 1));
}
