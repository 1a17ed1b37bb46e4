// Interleaved tiles: which pixel a texel stands for, and where the lists have a pixel.
#include "shared/gather.h"
#include "lib/direction.glsl"

// Divides integers from 0 to 2^24 by floats: a software rasteriser divides integers one by one. GLSL grants divisions an error,
// which may move a quotient by one.
ivec2 divide(ivec2 a, ivec2 b) {
    ivec2 quotient = ivec2((vec2(a) + 0.5) / vec2(b)), rest = a - quotient * b;
    return quotient + ivec2(greaterThanEqual(rest, b)) - ivec2(lessThan(rest, ivec2(0)));
}

// The pixel of the picture that a texel of a tile stands for; the tile by its place in the pattern.
ivec2 interleaved_pixel(interleaving pattern, ivec2 texel, ivec2 place) {
    return (texel - place * pattern.tile) * pattern.n + place;
}

// The texel of a pixel, in the tile of its place in the pattern.
ivec2 interleaved_texel(interleaving pattern, ivec2 pixel) {
    ivec2 texel = divide(pixel, ivec2(pattern.n)), place = pixel - texel * pattern.n;
    return place * pattern.tile + texel;
}

// Where the lists have a pixel, in one number, whose lowest bit is 0 where they do not: then it has the block that speaks
// for the pixel's visibility, by how far it is from that which the pixel lies in, and the normal of the triangle that the
// pixel sees.
uint list_texel_code(ivec2 texel, int level) {
    return 1u | uint(texel.x << 1 | texel.y << 16) | uint(level) << 31;
}

bool list_texel_has(uint code) {
    return (code & 1u) != 0u;
}

ivec2 list_texel_of(uint code) {
    return ivec2(code >> 1 & 0x7fffu, code >> 16 & 0x7fffu);
}

int list_level_of(uint code) {
    return int(code >> 31);
}

// -1 to 1 along x and y.
uint block_away_code(ivec2 away) {
    return uint(away.x & 3 | (away.y & 3) << 2) << 1;
}

ivec2 block_away_of(uint code) {
    return ivec2(bitfieldExtract(int(code), 1, 2), bitfieldExtract(int(code), 3, 2));
}

const float FACET_CODES = 8191.0;

uint facet_code(vec3 facet) {
    uvec2 code = uvec2(octahedral_encode(facet) * FACET_CODES + 0.5);
    return code.x << 6 | code.y << 19;
}

vec3 facet_of_code(uint code) {
    return octahedral_decode(vec2(code >> 6 & 0x1fffu, code >> 19) / FACET_CODES);
}
