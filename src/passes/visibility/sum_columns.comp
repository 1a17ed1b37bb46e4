// Summed area tables, second half: each invocation adds up a column, in place.
#include "shared/maps.h"

layout(local_size_x = SUM_LINES) in;
layout(SUM_FORMAT, binding = IMAGE_SUMS) uniform uimage2DArray sums;

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
