// The mean of a group of coefficients over a voxel and its neighbours, whose rays go between its own (volume/march.frag).
#include "lib/volume_distances.glsl"

layout(binding = UNIT_VOLUME_COEFFICIENTS) uniform sampler2D coefficients;

layout(location = TARGET_RESULT) out vec4 result;

void main() {
    ivec3 voxel = volume_voxel(ivec2(gl_FragCoord.xy)), last = ivec3(params.cells) - 1;
    result = vec4(0.0);
    if (voxel.z > last.z || !volume_is_read(voxel))
        return;
    ivec3 from = max(voxel - 1, ivec3(0)), to = min(voxel + 1, last);
    float count = 0.0;
    for (int z = from.z; z <= to.z; z++)
        for (int y = from.y; y <= to.y; y++)
            for (int x = from.x; x <= to.x; x++) {
                ivec3 other = ivec3(x, y, z);
                if (volume_is_read(other)) {
                    result += texelFetch(coefficients, volume_texel(other), 0);
                    count += 1.0;
                }
            }
    result /= count;
}
