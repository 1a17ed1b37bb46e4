// The mean of a group of coefficients over a voxel and its neighbours, whose rays go between its own (passes/volume/march.frag).
// Voxels that nobody reads have coefficients of 0. COUNT: how many of these voxels are read, over 255.
#include "lib/volume.glsl"

#ifndef COUNT
layout(binding = UNIT_VOLUME_COEFFICIENTS) uniform sampler2D coefficients;
layout(binding = UNIT_VOLUME_NEIGHBOURS) uniform sampler2D neighbour_counts;
#endif

layout(location = TARGET_RESULT) out vec4 result;

vec4 value_of(ivec3 voxel) {
#ifdef COUNT
    return vec4(volume_is_read(voxel) ? 1.0 / 255.0 : 0.0);
#else
    return texelFetch(coefficients, volume_texel(voxel), 0);
#endif
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec3 voxel = volume_voxel(texel), last = ivec3(params.cells) - 1;
    result = vec4(0.0);
    if (voxel.z > last.z || !volume_is_read(voxel))
        return;
#if PUBLISHED && !defined(COUNT)
    result = value_of(voxel);
    return;
#endif
    ivec3 from = max(voxel - 1, ivec3(0)), to = min(voxel + 1, last);
    for (int z = from.z; z <= to.z; z++)
        for (int y = from.y; y <= to.y; y++)
            for (int x = from.x; x <= to.x; x++)
                result += value_of(ivec3(x, y, z));
#ifndef COUNT
    result /= texelFetch(neighbour_counts, texel, 0).r * 255.0;
#endif
}
