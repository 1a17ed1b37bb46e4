// Two numbers in [0, 1) of a voxel, without a pattern that the eye sees [Jarzynski and Olano 2020].
vec2 volume_hash(ivec3 voxel) {
    uvec3 v = uvec3(voxel) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    return vec2(v.xy >> 8u) / 16777216.0;
}
