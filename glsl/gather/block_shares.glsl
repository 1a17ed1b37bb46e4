// What each of the four blocks around a pixel has of it, where no blur follows: between centres, of those on the same surface.
#include "gather/block.glsl"

bool block_shares(surface s, ivec2 pixel, out ivec2 first, out vec4 shares) {
    int size = params.block;
    first = first_block(pixel);
    float plane_apart = BLOCK_APART * view_height(camera, gbuffer_depth(pixel));
    vec2 second = clamp(vec2(pixel - first * size - size / 2) / float(size), 0.01, 0.99);
    for (int i = 0; i < 4; i++) {
        float share = ((i & 1) == 1 ? second.x : 1.0 - second.x) * (i > 1 ? second.y : 1.0 - second.y);
        shares[i] = is_alike(s, block_around(first, i), plane_apart) ? share : 0.0;
    }
    float sum = dot(shares, vec4(1.0));
    shares /= max(sum, 1e-30);
    return sum > 0.0;
}

float shared_visibility(ivec2 first, vec4 shares, int map) {
    float sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += shares[i] * texelFetch(block_visibilities, ivec3(block_around(first, i), map), 0).r;
    return sum;
}
