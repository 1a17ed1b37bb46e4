// Where the lists have a pixel, in one number, whose lower half is 0 where they do not: then the upper has the block that
// speaks for its visibility, by how far it is from that which the pixel lies in.
#include "shared/interleaving.h"

uint list_texel_code(ivec2 texel, int grade) {
    return uint(texel.x + 1 | texel.y << 16) | uint(grade) << 31;
}

bool list_texel_has(uint code) {
    return (code & 0xffffu) != 0u;
}

ivec2 list_texel_of(uint code) {
    return ivec2((code & 0xffffu) - 1u, code >> 16 & 0x7fffu);
}

int list_grade_of(uint code) {
    return int(code >> 31);
}

// -1 to 1 along x and y.
uint block_away_code(ivec2 away) {
    return uint(away.x & 3 | (away.y & 3) << 2) << 16;
}

ivec2 block_away_of(uint code) {
    return ivec2(bitfieldExtract(int(code), 16, 2), bitfieldExtract(int(code), 18, 2));
}
