// A fine texel that is empty, or shows what lies behind a hole in a nearer surface, takes the mean of the four
// coarse ones around it, by 9 : 3 : 3 : 1. But only where a point's disk would reach as far as a coarse texel: points
// that are denser leave no holes, and what looks like one is a gap. And only behind all four: a slope is no hole.
#include "techniques/imperfect-shadow-maps/fill.glsl"

layout(binding = UNIT_COARSE_DEPTH) uniform sampler2DArray coarse_depths;

#if !TO_MAP
layout(location = TARGET_RESULT) out float depth;
#endif

// 1 where none of the four has anything.
float coarse_mean(ivec2 texel, out float farthest) {
    farthest = 0.0;
    ivec2 own = texel >> 1, side = own + 2 * (texel & 1) - 1;
    ivec2 last = textureSize(coarse_depths, 0).xy - 1;
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; i++) {
        ivec2 place = ivec2((i & 1) == 0 ? own.x : side.x, (i >> 1) == 0 ? own.y : side.y);
        float found = texelFetch(coarse_depths, ivec3(clamp(place, ivec2(0), last), instance), 0).r;
        float weight = ((i & 1) == 0 ? 3.0 : 1.0) * ((i >> 1) == 0 ? 3.0 : 1.0) * (found < 1.0 ? 1.0 : 0.0);
        sum += weight * found;
        weights += weight;
        farthest = max(farthest, weight > 0.0 ? found : 0.0);
    }
    return weights > 0.0 ? sum / weights : 1.0;
}

bool reached(ivec2 texel, float found) {
    float wide = float(1 << params.level);
    vec2 place = (vec2(texel) + 0.5) * wide / params.map_size * 2.0 - 1.0;
    float distance = found * map_view_at(instance).z_far;
    float disk = 2.0 * params.radius / distance * params.map_size * (1.0 + dot(place, place)) * 0.25;
    return disk >= wide;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float farthest, own = fine_depth(texel), mean = coarse_mean(texel, farthest);
    bool hole = mean < 1.0 && (own == 1.0 || own > farthest + interval(params.level + 1)) && reached(texel, mean);
    float filled = hole ? mean : own;
#if TO_MAP
    gl_FragDepth = filled;
#else
    depth = filled;
#endif
}
