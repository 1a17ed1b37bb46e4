// How far the nearest occupied voxel is (passes/volume/distance.frag).
#include "lib/volume.glsl"

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
