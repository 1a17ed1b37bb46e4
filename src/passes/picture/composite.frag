// The picture for a display: exposure, tone map, sRGB. Twice: by what pixels' centres see, and where a pixel's samples
// see something else, which the depth then says, by all of them. Few pixels are: a software rasteriser skips what
// fails the test, but executes both sides of a branch.
#include "passes/picture/layer.glsl"

#ifndef CENTERS
layout(early_fragment_tests) in;
#endif

layout(location = TARGET_RESULT) out vec4 color;

seen seen_in_turn(ivec2 pixel) {
    uvec2 assignment = assignment_at(pixel);
#ifdef CENTERS
    gl_FragDepth = assignment == uvec2(0u) ? 0.5 : 0.0;
    assignment = uvec2(0u);
#endif
    return seen_by(assignment, pixel);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int shown = params.layer;
    seen s = seen_in_turn(pixel);
    vec3 radiance = shown == LAYER_DIRECT     ? s.direct
                    : shown == LAYER_INDIRECT ? s.indirect
                                              : s.radiance;
    color = display_before(shown, radiance, shown == LAYER_BEAUTY ? s.opacity : s.coverage);
}
