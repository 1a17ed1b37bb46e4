// Where the lists have a pixel, in one number; 0 where they do not.
#include "shared/interleaving.h"

uint list_texel_code(ivec2 texel, int grade) {
    return uint(texel.x + 1 | texel.y << 16) | uint(grade) << 31;
}

ivec2 list_texel_of(uint code) {
    return ivec2((code & 0xffffu) - 1u, code >> 16 & 0x7fffu);
}

int list_grade_of(uint code) {
    return int(code >> 31);
}
