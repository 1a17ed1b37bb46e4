// What rays became, by texel.
#include "shared/caustics.h"

layout(binding = UNIT_RAY_LEAVES) uniform sampler2D ray_leaves;
layout(binding = UNIT_RAY_ENDS) uniform sampler2D ray_ends;
layout(binding = UNIT_RAY_FLUXES) uniform sampler2D ray_fluxes;

vec3 end_normal(vec4 leave) {
    return normalize(unpackSnorm4x8(floatBitsToUint(leave.w)).xyz);
}

ivec2 ray_texel(int number) {
    return ivec2(number % params.side, number / params.side);
}
