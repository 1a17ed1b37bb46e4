// A coarse texel is the mean of those of its four finer ones that are of its nearest surface.
#include "techniques/imperfect-shadow-maps/fill.glsl"

layout(location = TARGET_RESULT) out float depth;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * 2;
    float depths[4], nearest = 1.0;
    for (int i = 0; i < 4; i++) {
        depths[i] = fine_depth(first + ivec2(i & 1, i >> 1));
        nearest = min(nearest, depths[i]);
    }
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < 4; i++) {
        float own = depths[i] < 1.0 && depths[i] <= nearest + interval(params.level) ? 1.0 : 0.0;
        sum += own * depths[i];
        count += own;
    }
    depth = count > 0.0 ? sum / count : 1.0;
}
