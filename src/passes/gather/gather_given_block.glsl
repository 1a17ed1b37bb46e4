// A block has a pixel's visibility: the texel that says that the pixel is not on a list tells which one.
#include "passes/gather/visibility_block.glsl"

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    return light_by_block(s, lights, block_at(pixel) + block_away_of(texelFetch(list_texels, pixel, 0).r));
}
