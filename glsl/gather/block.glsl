// Visibility shared by blocks of pixels: which block speaks for a pixel.
#include "lib/gbuffer.glsl"
#include "shared/gather.h"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;

const float BLOCK_COSINE = 0.8;

// The pixel where a block looks itself up.
ivec2 block_center(ivec2 block, int size, ivec2 picture) {
    return min(block * size + size / 2, picture - 1);
}

// The first of the four blocks around a pixel.
ivec2 first_block(ivec2 pixel, int size) {
    return (pixel + size / 2) / size - 1;
}

// Whether the block's centre lies on the surface; how far away it is, squared.
bool is_alike(surface s, ivec2 block, float plane_apart, out float distance2) {
    surface c = gbuffer_surface(block_center(block, params.block, gbuffer_size()));
    vec3 apart = c.position - s.position;
    distance2 = dot(apart, apart);
    return c.present && dot(c.normal, s.normal) > BLOCK_COSINE && abs(dot(apart, s.normal)) < plane_apart;
}

ivec2 block_around(ivec2 first, int i) {
    return clamp(first + ivec2(i & 1, i >> 1), ivec2(0), textureSize(block_visibilities, 0).xy - 1);
}

// Of the four blocks around a pixel the one whose centre lies nearest among those on the same surface;
// false where there is none.
bool nearest_block(surface s, ivec2 pixel, out ivec2 nearest) {
    ivec2 first = first_block(pixel, params.block);
    float least = 1e30, plane_apart = params.block_apart * view_height(camera, gbuffer_depth(pixel));
    nearest = ivec2(0);
    for (int i = 0; i < 4; i++) {
        ivec2 block = block_around(first, i);
        float distance2;
        if (is_alike(s, block, plane_apart, distance2) && distance2 < least) {
            least = distance2;
            nearest = block;
        }
    }
    return least < 1e30;
}

#if CLAMP >= 6
// Their shares of the pixel, where no blur follows: between centres, of those on the same surface.
bool block_shares(surface s, ivec2 pixel, out ivec2 first, out vec4 shares) {
    int size = params.block;
    first = first_block(pixel, size);
    float plane_apart = params.block_apart * view_height(camera, gbuffer_depth(pixel)), distance2;
    vec2 second = clamp(vec2(pixel - first * size - size / 2) / float(size), 0.01, 0.99);
    for (int i = 0; i < 4; i++) {
        float share = ((i & 1) == 1 ? second.x : 1.0 - second.x) * (i > 1 ? second.y : 1.0 - second.y);
        shares[i] = is_alike(s, block_around(first, i), plane_apart, distance2) ? share : 0.0;
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
#endif
