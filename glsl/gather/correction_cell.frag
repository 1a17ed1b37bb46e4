// The corrections of a cell: a part of its VAL, which is a part of all.
#include "gather/correction_of_tests.glsl"

layout(binding = UNIT_CORRECTION) uniform sampler2D mean_corrections; // gather/correction_mean.frag

flat in int instance;

layout(location = TARGET_RESULT) out vec2 corrections;

void main() {
    test_sums own = test_sums(vec4(0.0), vec2(0.0));
    sums_add(own, instance);
    vec2 of_val = corrections_of(own, texelFetch(mean_corrections, ivec2(0), 0).rg);
    corrections = corrections_of(sums_of_cell(ivec2(gl_FragCoord.xy), instance), of_val);
}
