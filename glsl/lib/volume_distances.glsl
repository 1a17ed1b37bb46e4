// How far the nearest occupied voxel is (volume/distance.frag).
#include "lib/volume.glsl"

layout(binding = UNIT_VOLUME_DISTANCES) uniform sampler2D volume_distances;

// Voxels, 0 of an occupied voxel, VOLUME_DISTANCE_MAX where it is farther or not known.
int volume_distance(ivec3 voxel) {
    return int(texelFetch(volume_distances, volume_texel(voxel), 0).r * 255.0 + 0.5);
}
