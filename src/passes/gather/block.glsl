// Visibility shared by blocks of pixels, of a pass with `block` among its parameters: which block speaks for a pixel.
#include "lib/tiles.glsl"
#include "lib/gbuffer.glsl"

#ifndef BLOCK_COSINE
#define BLOCK_COSINE 0.8
#endif
// Over the picture's height: farther off a block's plane, a pixel is not the block's.
const float BLOCK_APART = 0.008;

// The block that a pixel lies in.
ivec2 block_at(ivec2 pixel) {
    return divide(pixel, ivec2(params.block));
}

// The pixel where a block looks itself up.
ivec2 block_center(ivec2 block) {
    return min(block * params.block + params.block / 2, gbuffer_size() - 1);
}

// The first of the four blocks around a pixel.
ivec2 first_block(ivec2 pixel) {
    return block_at(pixel + params.block / 2) - 1;
}

ivec2 block_around(ivec2 first, int i) {
    return clamp(first + ivec2(i & 1, i >> 1), ivec2(0), block_at(gbuffer_size() - 1));
}

// Whether the block's centre lies on the surface.
bool is_alike(surface s, ivec2 block, float plane_apart) {
    surface c = gbuffer_surface(block_center(block));
    return c.present && dot(c.normal, s.normal) > BLOCK_COSINE &&
           abs(dot(c.position - s.position, s.normal)) < plane_apart;
}

// Of the four blocks around a pixel the one whose centre lies nearest in the picture among those on the same surface;
// false where there is none.
bool nearest_block(surface s, ivec2 pixel, out ivec2 nearest) {
    ivec2 first = first_block(pixel);
    int least = 0x7fffffff;
    float plane_apart = BLOCK_APART * view_height(camera, gbuffer_depth(pixel));
    nearest = ivec2(0);
    for (int i = 0; i < 4; i++) {
        ivec2 block = block_around(first, i), away = block_center(block) - pixel;
        int distance2 = away.x * away.x + away.y * away.y;
        bool alike = is_alike(s, block, plane_apart), nearer = alike && distance2 < least;
        least = nearer ? distance2 : least;
        nearest = nearer ? block : nearest;
    }
    return least < 0x7fffffff;
}
