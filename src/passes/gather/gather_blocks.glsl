// Visibility that blocks of pixels share, by TESTED. Where no block is on the pixel's surface, the pixel tests it.
#include "passes/gather/block.glsl"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;

float block_visibility(ivec2 block, int map) {
    return texelFetch(block_visibilities, ivec3(block, map), 0).r;
}

#if TESTED == TESTED_BY_BLOCKS
// Where no blur follows, the four blocks around a pixel: between centres, of those on the same surface.
struct block_shares {
    ivec2 first;
    vec4 shares; // of the four blocks from there on
};
#define BLOCKS block_shares

float block_visibility(block_shares around, int map) {
    float sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += around.shares[i] * block_visibility(block_around(around.first, i), map);
    return sum;
}

// False where none is on the pixel's surface.
bool find_blocks(surface s, ivec2 pixel, out block_shares around) {
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
    around = block_shares(first, shares / max(sum, 1e-30));
    return sum > 0.0;
}
#else
#define BLOCKS ivec2

bool find_blocks(surface s, ivec2 pixel, out ivec2 nearest) {
    return nearest_block(s, pixel, nearest);
}
#endif

vec3 light_by_block(surface s, ivec2 lights, BLOCKS around) {
    vec3 sum = vec3(0.0), back;
    for (int i = lights.x; i < lights.y; i++) {
        vpl light = light_at(i);
        float visible = block_visibility(around, map_of(i, light));
        sum += arriving(unshadowed(i, light, s, back), back, visible);
    }
    return sum;
}

#if TESTED == TESTED_BY_GIVEN_BLOCK
// The texel that says that the pixel is not on a list tells which block has its visibility.
vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    return light_by_block(s, lights, block_at(pixel) + block_away_of(texelFetch(list_texels, pixel, 0).r));
}
#else
#include "passes/gather/visibility_pixel.glsl"

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    BLOCKS around;
    int last = find_blocks(s, pixel, around) ? lights.y : lights.x;
    return light_by_block(s, ivec2(lights.x, last), around) + light_by_pixel(s, ivec2(last, lights.y));
}
#endif
