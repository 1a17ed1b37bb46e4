// The corrections of all VALs together. The sums are those of gather/correction_val.frag.
#include "gather/correction_of_tests.glsl"

layout(location = TARGET_RESULT) out vec2 corrections;

void main() {
    test_sums all = test_sums(vec4(0.0), vec2(0.0));
    for (int val = 0; val < textureSize(sums, 0).z; val++)
        sums_add(all, sums_of_cell(ivec2(0), val));
    corrections = corrections_of(all, vec2(0.0));
}
