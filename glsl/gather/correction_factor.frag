// The gains of a cell: a part of its VAL, which is a part of all.
#include "gather/correction_factor.glsl"

layout(binding = UNIT_CORRECTION) uniform sampler2D mean_gains; // gather/correction_mean.frag

flat in int instance;

layout(location = TARGET_RESULT) out vec2 gains;

void main() {
    test_sums own = test_sums(vec4(0.0), vec2(0.0));
    sums_add(own, instance);
    vec2 of_val = gains_of(own, texelFetch(mean_gains, ivec2(0), 0).rg);
    gains = gains_of(sums_of_cell(ivec2(gl_FragCoord.xy), instance), of_val);
}
