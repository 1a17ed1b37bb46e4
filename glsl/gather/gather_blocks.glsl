// Where no blur follows, the four blocks around a pixel have its visibility: between centres, of those on the same
// surface. Where there is none, the pixel tests it.
#include "gather/visibility_block.glsl"
#include "gather/visibility_pixel.glsl"

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

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    vec3 sum = vec3(0.0), back;
    ivec2 first;
    vec4 shares;
    int last = block_shares(s, pixel, first, shares) ? lights.y : lights.x;
    for (int i = lights.x; i < last; i++) {
        vpl light = light_at(i);
        float visible = shared_visibility(first, shares, map_of(i, light));
        sum += arriving(unshadowed(i, light, s, back), back, visible);
    }
    return sum + light_by_pixel(s, ivec2(last, lights.y));
}
