// A step of pull or, without PULL, of push. Depths are the map's, and 1 where nothing is.
#include "passes/visibility/map_views.glsl"
#include "passes/visibility/paraboloid.glsl"
#include "shared/splat.h"

PASS_BLOCK(fill_params, 16)

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray fine_depths;

flat in int instance; // the map

float fine_depth(ivec2 texel) {
    return texelFetch(fine_depths, ivec3(texel, instance), 0).r;
}

// Depths that far apart may be of one surface, in texels of a level.
float interval(int level) {
    return 2.0 * params.radius * float(1 << level) / map_view_at(instance).z_far;
}

#ifdef PULL
// A coarse texel is the mean of those of its four finer ones that are of its nearest surface.
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
#else
// A fine texel that is empty, or shows what lies behind a hole in a nearer surface, takes the mean of the four
// coarse ones around it, by 9 : 3 : 3 : 1. But only where a point's disk would reach as far as a coarse texel: points
// that are denser leave no holes, and what looks like one is a gap. And only behind all four: a slope is no hole.
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
#endif
