// The nearest block on a pixel's surface has its visibility; where there is none, the pixel tests it.
#include "passes/gather/visibility_block.glsl"
#include "passes/gather/visibility_pixel.glsl"

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    ivec2 block;
    int last = nearest_block(s, pixel, block) ? lights.y : lights.x;
    return light_by_block(s, ivec2(lights.x, last), block) + light_by_pixel(s, ivec2(last, lights.y));
}
