// What a test is about: texel (x, y) of their texture is the x-th test in cell y of the picture, which take the groups of
// VPLs in turn.
#include "shared/correction.h"

int test_group(ivec2 texel) {
    return (texel.y * params.tests_of_cell + texel.x) % params.groups;
}

// In the picture, from 0 to 1.
vec2 test_place(ivec2 texel) {
    ivec2 cell = ivec2(texel.y % CORRECTION_SIDE, texel.y / CORRECTION_SIDE);
    vec2 own = float(texel.y) * vec2(0.6180339887, 0.4142135624);
    vec2 within = fract((float(texel.x) + 0.5) * vec2(0.7548776662, 0.5698402910) + own);
    return (vec2(cell) + within) / float(CORRECTION_SIDE);
}
