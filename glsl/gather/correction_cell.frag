// The corrections of a cell: a part of its VAL, which is a part of all.
#include "gather/correction_of_tests.glsl"

layout(binding = UNIT_CORRECTION) uniform sampler2D mean_corrections; // gather/correction_mean.frag

layout(binding = UNIT_CORRECTION_VAL_SUMS) uniform sampler2DArray val_sums; // gather/correction_val.frag
layout(binding = UNIT_CORRECTION_VAL_SQUARES) uniform sampler2DArray val_squares;

flat in int instance;

layout(location = TARGET_RESULT) out vec2 corrections;

void main() {
    ivec3 val = ivec3(0, 0, instance);
    test_sums own = test_sums(texelFetch(val_sums, val, 0), texelFetch(val_squares, val, 0).rg);
    vec2 of_val = corrections_of(own, texelFetch(mean_corrections, ivec2(0), 0).rg);
    corrections = corrections_of(sums_of_cell(ivec2(gl_FragCoord.xy), instance), of_val);
}
