// The first four moments of a texel of a map of depth, in fixed point.
#include "shared/sums.h"

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

uvec4 summed(ivec3 texel) {
    float z = min(max(texelFetch(depths, texel, 0).r, 0.0), 1.0); // also where it is no number
    precise float z2 = z * z, z3 = z2 * z, z4 = z2 * z2;
    precise vec4 scaled = vec4(z, z2, z3, z4) * SUM_ONE;
    return uvec4(roundEven(scaled));
}
