// Distance of each voxel to the nearest occupied one, by the greatest difference along an axis, an axis at a time: each
// step takes the lesser of what its neighbours along AXIS have, but at least how far off they are.
#include "lib/volume.glsl"

#if AXIS == 0
layout(binding = UNIT_VOLUME_SURFACES) uniform sampler2D surfaces;

int nearer(ivec3 voxel) {
    return texelFetch(surfaces, volume_texel(voxel), 0).a > 0.0 ? 0 : VOLUME_DISTANCE_MAX;
}
#else
#include "lib/volume_distances.glsl"

int nearer(ivec3 voxel) {
    return volume_distance(voxel);
}
#endif

layout(location = TARGET_RESULT) out float result;

void main() {
    ivec3 voxel = volume_voxel(ivec2(gl_FragCoord.xy));
    result = float(VOLUME_DISTANCE_MAX) / 255.0;
    int last = int(params.cells[AXIS]) - 1, least = VOLUME_DISTANCE_MAX;
    if (voxel.z >= int(params.cells.z))
        return;
    for (int off = max(-voxel[AXIS], 1 - VOLUME_DISTANCE_MAX); off < min(last - voxel[AXIS] + 1, VOLUME_DISTANCE_MAX); off++) {
        ivec3 other = voxel;
        other[AXIS] += off;
        least = min(least, max(nearer(other), abs(off)));
    }
    result = float(least) / 255.0;
}
