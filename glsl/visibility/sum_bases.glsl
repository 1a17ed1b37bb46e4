// What summed area tables of Fourier bases add up of a texel, in fixed point. Tables follow each other by shared/sums.h.
#include "shared/sums.h"
#include "visibility/series_bases.glsl"

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

uvec4 summed(ivec3 texel) {
    int map = texel.z % MAP_COUNT, table = texel.z / MAP_COUNT, kind = table / BASIS_GROUPS;
    float z = texelFetch(depths, ivec3(texel.xy, map), 0).r;
    series_bases b = series_bases_of(map, z, 4 * (table % BASIS_GROUPS));
    vec4 value = kind % 2 == 0 ? b.cosines : b.sines;
    value = kind < 2 ? value : kind < 4 ? b.a * value : vec4(b.a);
    precise vec4 scaled = clamp(value * 0.5 + 0.5, 0.0, 1.0) * SUM_BASIS_ONE;
    return uvec4(roundEven(scaled));
}
