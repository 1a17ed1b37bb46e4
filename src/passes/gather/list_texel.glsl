// Where the lists have a pixel, in one number, whose lowest bit is 0 where they do not: then it has the block that speaks
// for the pixel's visibility, by how far it is from that which the pixel lies in, and the normal of the triangle that the
// pixel sees.
#include "shared/gather.h"
#include "lib/octahedral.glsl"

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
