// By how much lookups are to be corrected, so that in sum as much light arrives as rays say: part of what they let through
// is taken off, or part of what they stop let through. What few tests say of a part may be chance: of what it differs
// from the whole by, the part stays that chance does not explain [James and Stein 1961; Efron and Morris 1973].
#include "shared/bindings.h"
#include "shared/correction.h"

layout(binding = UNIT_CORRECTION_SUMS) uniform sampler2DArray sums;
layout(binding = UNIT_CORRECTION_SQUARES) uniform sampler2DArray squares;

// Variances that chance explains. With one, maps that are right already lose more than others gain.
const float CHANCE = 2.0;

// What tests say (gather/correction_sum.frag).
struct test_sums {
    vec4 light;
    vec2 squares;
};

test_sums sums_of_cell(ivec2 cell, int val) {
    return test_sums(texelFetch(sums, ivec3(cell, val), 0), texelFetch(squares, ivec3(cell, val), 0).rg);
}

void sums_add(inout test_sums sum, test_sums more) {
    sum.light += more.light;
    sum.squares += more.squares;
}

// Of all light, less than this is nothing: rounding alone would tell which part of nothing is missing.
const float NOTHING = 1e-4;

// Of a part of the light; `whole`: the correction of that which it is a part of.
float correction_of(float all, float found, float due, float square, float whole) {
    float stopped = max(all - found, NOTHING * all), passed = max(found, NOTHING * all);
    float whole_more = whole * (whole > 0.0 ? stopped : passed), off = due - found - whole_more;
    float sure = max(1.0 - CHANCE * square / max(off * off, 1e-30), 0.0);
    float more = whole_more + sure * off, part = more > 0.0 ? stopped : passed;
    return clamp(more / max(part, 1e-30), -1.0, 1.0);
}

// Of lookups by pixels and by blocks.
vec2 corrections_of(test_sums sum, vec2 whole) {
    vec4 light = sum.light;
    return vec2(correction_of(light.r, light.g, light.a, sum.squares.r, whole.r),
                correction_of(light.r, light.b, light.a, sum.squares.g, whole.g));
}
