// What a test is about: texel (x, y) of their texture is the x-th test in cell y of the picture, which take the groups of
// VPLs in turn.
#include "lib/lattice.glsl"
#include "shared/correction.h"

int test_group(ivec2 texel) {
    return (texel.y * params.tests_of_cell + texel.x) % params.groups;
}

// In the picture, from 0 to 1.
vec2 test_place(ivec2 texel) {
    ivec2 cell = ivec2(texel.y % CORRECTION_SIDE, texel.y / CORRECTION_SIDE);
    uvec2 own = uint(texel.y) * uvec2(LATTICE_GOLDEN, LATTICE_ROOT_2);
    uvec2 turns = uint(texel.x) * LATTICE_PLASTIC + LATTICE_PLASTIC / 2u + own;
    vec2 within = vec2(lattice_number(turns.x), lattice_number(turns.y));
    return (vec2(cell) + within) / float(CORRECTION_SIDE);
}

// Which of its group it takes, by a number from 0 to 1.
float test_random(ivec2 texel) {
    return lattice_number(uint(texel.x) * LATTICE_GOLDEN + uint(texel.y) * LATTICE_ROOT_3);
}
