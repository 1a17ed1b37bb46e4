// What a cell's tests say of a VAL: all of its light that they are about, and how much of it arrives by its map, by
// blocks, and by rays; and the sums of squares of what rays say more than map and block.
#include "shared/bindings.h"
#include "shared/correction.h"

layout(binding = UNIT_CORRECTION_TESTS) uniform sampler2D tests;

flat in int instance;

layout(location = TARGET_CORRECTION_SUM) out vec4 light;
layout(location = TARGET_CORRECTION_SQUARE) out vec2 squares;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int cell = at.y * CORRECTION_SIDE + at.x;
    light = vec4(0.0);
    squares = vec2(0.0);
    for (int i = 0; i < textureSize(tests, 0).x; i++) {
        vec4 test = texelFetch(tests, ivec2(i, cell), 0);
        float own = int(abs(test.a)) == instance + 1 ? test.r : 0.0, arrives = test.a > 0.0 ? 1.0 : 0.0;
        vec2 more = own * (arrives - test.gb);
        light += own * vec4(1.0, test.gb, arrives);
        squares += more * more;
    }
}
