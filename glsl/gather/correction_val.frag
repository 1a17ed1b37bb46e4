// What the tests of all cells say of a VAL. One invocation for all VALs would be the longest chain of the frame.
#include "gather/correction_of_tests.glsl"

flat in int instance;

layout(location = TARGET_CORRECTION_SUM) out vec4 val_light;
layout(location = TARGET_CORRECTION_SQUARE) out vec2 val_squares;

void main() {
    test_sums sum = test_sums(vec4(0.0), vec2(0.0));
    for (int i = 0; i < CORRECTION_SIDE * CORRECTION_SIDE; i++)
        sums_add(sum, sums_of_cell(ivec2(i % CORRECTION_SIDE, i / CORRECTION_SIDE), instance));
    val_light = sum.light;
    val_squares = sum.squares;
}
