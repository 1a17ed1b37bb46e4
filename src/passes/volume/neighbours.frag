// How many of a voxel and its neighbours are read (passes/volume/smooth.frag), over 255.
#include "lib/volume_distances.glsl"

layout(location = TARGET_RESULT) out float result;

void main() {
    ivec3 voxel = volume_voxel(ivec2(gl_FragCoord.xy)), last = ivec3(params.cells) - 1;
    result = 0.0;
    if (voxel.z > last.z || !volume_is_read(voxel))
        return;
    ivec3 from = max(voxel - 1, ivec3(0)), to = min(voxel + 1, last);
    for (int z = from.z; z <= to.z; z++)
        for (int y = from.y; y <= to.y; y++)
            for (int x = from.x; x <= to.x; x++)
                result += volume_is_read(ivec3(x, y, z)) ? 1.0 / 255.0 : 0.0;
}
