// Voxels of a volume: slices side by side in an atlas. Places within the volume are in voxels from its corner.
#include "shared/volume.h"

ivec2 volume_texel(ivec3 voxel) {
    ivec2 slice = ivec2(voxel.z & ((1 << params.columns_log2) - 1), voxel.z >> params.columns_log2);
    return slice * ivec2(params.cells.xy) + voxel.xy;
}

// The voxel of a texel; beyond the last slice a voxel outside.
ivec3 volume_voxel(ivec2 texel) {
    ivec2 slice = ivec2((vec2(texel) + 0.5) / params.cells.xy);
    return ivec3(texel - slice * ivec2(params.cells.xy), (slice.y << params.columns_log2) + slice.x);
}

bool volume_has(vec3 place) {
    return all(greaterThanEqual(place, vec3(0.0))) && all(lessThan(place, params.cells));
}

vec3 volume_place(vec3 position) {
    return (position - params.corner) / params.voxel;
}
