// Where no blur follows, the four blocks around a pixel have its visibility: between centres, of those on the same
// surface. Where there is none, the pixel tests it.
struct block_shares {
    ivec2 first;
    vec4 of; // the four blocks from there on
};

float block_visibility(block_shares blocks, int map);
#define BLOCKS block_shares
#include "passes/gather/visibility_block.glsl"
#include "passes/gather/visibility_pixel.glsl"

// False where none is on the pixel's surface.
bool find_blocks(surface s, ivec2 pixel, out block_shares blocks) {
    int size = params.block;
    ivec2 first = first_block(pixel);
    vec4 shares;
    float plane_apart = BLOCK_APART * view_height(camera, gbuffer_depth(pixel));
    vec2 second = clamp(vec2(pixel - first * size - size / 2) / float(size), 0.01, 0.99);
    for (int i = 0; i < 4; i++) {
        float share = ((i & 1) == 1 ? second.x : 1.0 - second.x) * (i > 1 ? second.y : 1.0 - second.y);
        shares[i] = is_alike(s, block_around(first, i), plane_apart) ? share : 0.0;
    }
    float sum = dot(shares, vec4(1.0));
    blocks = block_shares(first, shares / max(sum, 1e-30));
    return sum > 0.0;
}

float block_visibility(block_shares blocks, int map) {
    float sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += blocks.of[i] * block_visibility(block_around(blocks.first, i), map);
    return sum;
}

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    block_shares blocks;
    int last = find_blocks(s, pixel, blocks) ? lights.y : lights.x;
    return light_by_block(s, ivec2(lights.x, last), blocks) + light_by_pixel(s, ivec2(last, lights.y));
}
