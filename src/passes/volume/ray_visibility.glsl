// Rays of ambient occlusion: 1 where nothing is met, or what panes let pass.
#include "lib/medium.glsl"

#define gathered float[1]

gathered ray_end(ivec3 voxel, bool met, vec3 origin, vec3 direction, float metres) {
    return float[1](met ? 0.0 : dot(medium_panes(origin, direction, metres), vec3(1.0 / 3.0)));
}
