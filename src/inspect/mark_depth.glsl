// What lies behind a surface is drawn faint.
#include "lib/gbuffer.glsl"

float mark_presence(vec2 pixel, float reversed_depth) {
    float depth = gbuffer_depth(ivec2(pixel));
    float mark = view_linear_depth(camera, reversed_depth);
    bool hidden = depth > 0.0 && mark > 1.02 * view_linear_depth(camera, depth);
    return hidden ? 0.12 : 1.0;
}
