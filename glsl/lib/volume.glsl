// Voxels of a volume: slices side by side in an atlas. Places within the volume are in voxels from its corner. The including
// program has the defines of volume_defines (passes/volumes.c).
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

// How far the nearest occupied voxel is (passes/volume/distance.frag).
layout(binding = UNIT_VOLUME_DISTANCES) uniform sampler2D volume_distances;

int volume_distance_code(ivec3 voxel) {
    return int(texelFetch(volume_distances, volume_texel(voxel), 0).r * 255.0 + 0.5);
}

// Voxels, 0 of an occupied voxel, VOLUME_DISTANCE_MAX where it is farther or not known.
int volume_distance(ivec3 voxel) {
    return volume_distance_code(voxel) & (VOLUME_IDLE - 1);
}

// Whether surfaces read the voxel: it is near to one and no idle one, and empty unless all is as published.
bool volume_is_read(ivec3 voxel) {
    int code = volume_distance_code(voxel);
    return code >= (PUBLISHED == 1 ? 0 : 1) && code <= VOLUME_SHELL;
}

// Voxels whose surfaces face several ways, as those of a thin wall, have two sides: their turned points and the others
// (passes/volume/inject.vert).
layout(binding = UNIT_VOLUME_SURFACES) uniform sampler2D surfaces;
#if SPLIT
layout(binding = UNIT_VOLUME_TURNED_SURFACES) uniform sampler2D turned_surfaces;
#endif

// Below this part of their number normals show several ways.
const float FACING = 0.5;

bool has_sides(vec4 surface) {
    return dot(surface.xyz, surface.xyz) < FACING * FACING * surface.a * surface.a;
}
