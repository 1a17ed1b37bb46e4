// Summed area tables: first each invocation adds up a row of moments, or of Fourier bases; then, with COLUMNS, a column, in place.
#include "shared/maps.h"

layout(local_size_x = SUM_LINES) in;
layout(SUM_FORMAT, binding = IMAGE_SUMS) uniform uimage2DArray sums;

#ifdef COLUMNS
void main() {
    ivec2 size = imageSize(sums).xy;
    int column = int(gl_GlobalInvocationID.x), layer = int(gl_GlobalInvocationID.z);
    if (column >= size.x)
        return;
    uvec4 sum = uvec4(0u);
    imageStore(sums, ivec3(column, 0, layer), sum);
    for (int y = 1; y < size.y; y++) {
        sum += imageLoad(sums, ivec3(column, y, layer));
        imageStore(sums, ivec3(column, y, layer), sum);
    }
}
#else
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

#ifdef BASIS_TERMS
// The Fourier bases of a texel, in fixed point. Tables follow each other by shared/maps.h.
#include "passes/visibility/series.glsl"

uvec4 summed(ivec3 texel) {
    int map = texel.z % MAP_COUNT, table = texel.z / MAP_COUNT, kind = table / BASIS_GROUPS;
    float z = texelFetch(depths, ivec3(texel.xy, map), 0).r;
    series_bases b = series_bases_of(map, z, 4 * (table % BASIS_GROUPS));
    vec4 value = kind % 2 == 0 ? b.cosines : b.sines;
    value = kind < 2 ? value : kind < 4 ? b.a * value : vec4(b.a);
    precise vec4 scaled = clamp(value * 0.5 + 0.5, 0.0, 1.0) * SUM_BASIS_ONE;
    return uvec4(roundEven(scaled));
}
#else
// The first four moments of a texel of a map of depth, in fixed point.
uvec4 summed(ivec3 texel) {
    float z = min(max(texelFetch(depths, texel, 0).r, 0.0), 1.0); // also where it is no number
    precise float z2 = z * z, z3 = z2 * z, z4 = z2 * z2;
    precise vec4 scaled = vec4(z, z2, z3, z4) * SUM_ONE;
    return uvec4(roundEven(scaled));
}
#endif

void main() {
    int size = textureSize(depths, 0).x, row = int(gl_GlobalInvocationID.x), layer = int(gl_GlobalInvocationID.z);
    if (row >= size)
        return;
    uvec4 sum = uvec4(0u);
    for (int x = 0; x < size; x++) {
        imageStore(sums, ivec3(x, row + 1, layer), sum);
        sum += summed(ivec3(x, row, layer));
    }
    imageStore(sums, ivec3(size, row + 1, layer), sum);
}
#endif
