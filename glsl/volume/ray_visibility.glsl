// Rays of ambient occlusion: 1 where nothing is met.
#define gathered float[1]

gathered ray_end(ivec3 voxel, bool met, vec3 direction) {
    return float[1](met ? 0.0 : 1.0);
}
