// How importance divides a node of a light's domain among its quarters.
#include "passes/lights/vpl_density.glsl"
#include "shared/importance_map.h"

// Value and number of the candidates that landed on a cell; on further levels the means over 2 x 2, 4 x 4 ... cells.
layout(binding = UNIT_IMPORTANCE_VALUES) uniform sampler2D importance_values;

// The fraction of VPLs that follows flux alone, so that density has a lower bound: candidates may miss what matters.
const float IMPORTANCE_LEAST = 0.25;

// Mean value and number over the domain of a light.
vec2 importance_of_light(int index) {
    return texelFetch(importance_values, importance_tile(index), VPL_DENSITY_LEVELS - 1).rg;
}

// Of the quarters 00, 10, 01, 11 of a node: texels of `level` from `cell` on, of the light's tile. A few candidates say
// little, so each quarter counts as if PRIOR more of the light's mean value had landed there.
vec4 importance_parts(int index, ivec2 cell, int level) {
    const float PRIOR = 4.0;
    ivec2 first = importance_tile(index) * (VPL_DENSITY_SIDE >> level) + cell;
    vec2 mean = importance_of_light(index);
    float cells = float(1 << (2 * level));
    float least = IMPORTANCE_LEAST / (1.0 - IMPORTANCE_LEAST) * mean.r * cells;
    float prior = PRIOR * mean.r / max(mean.g, 1e-30);
    vec4 parts;
    for (int i = 0; i < 4; i++)
        parts[i] = texelFetch(importance_values, first + ivec2(i & 1, i >> 1), level).r * cells + least + prior;
    return mean.r > 0.0 ? parts : vec4(1.0);
}
