// Summed area tables, first half: each invocation adds up a row of moments, or of Fourier bases.
#ifdef BASIS_TERMS
#include "visibility/sum_bases.glsl"
#else
#include "visibility/moments.glsl"
#endif

layout(local_size_x = SUM_LINES) in;
layout(SUM_FORMAT, binding = IMAGE_SUMS) writeonly uniform uimage2DArray sums;

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
