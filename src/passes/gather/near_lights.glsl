// What the lights' views see, as the near field reads it.
#include "lib/light.glsl"
#include "passes/gather/near_light.glsl"
#include "shared/gather.h"

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

// That has the point.
ivec2 near_texel(vec2 ndc, int size) {
    return clamp(ivec2((ndc * 0.5 + 0.5) * float(size)), ivec2(0), ivec2(size - 1));
}
