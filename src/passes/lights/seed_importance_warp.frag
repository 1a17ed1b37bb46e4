// The number of the VPL where cluster k begins: Halton's point k, warped so that as many lie where the importance is
// greater [Clarberg et al. 2005]. From all of the light's domain down to a cell: its halves along u, then along v, are
// stretched to their shares. -1 where the cell has no VPL.
#include "lib/random.glsl"
#include "shared/seed_importance.h"

layout(binding = UNIT_SEED_IMPORTANCE) uniform sampler2D importances; // with means over 2 x 2, 4 x 4 ... cells
layout(binding = UNIT_VPL_NUMBERS) uniform sampler2D numbers;

layout(location = TARGET_RESULT) out float seed;

// No cell has none: of the mean.
const float LEAST = 0.05;

float radical_inverse(int base, int i) {
    float digit = 1.0 / float(base), sum = 0.0;
    for (; i > 0; i /= base) {
        sum += float(i % base) * digit;
        digit /= float(base);
    }
    return sum;
}

void main() {
    int k = int(gl_FragCoord.x);
    vec2 place = vec2(radical_inverse(2, k + 1), radical_inverse(3, k + 1));
    float least = max(LEAST * texelFetch(importances, ivec2(0), SEED_IMPORTANCE_LEVELS - 1).r, 1e-30);
    ivec2 cell = ivec2(0);
    for (int level = SEED_IMPORTANCE_LEVELS - 2; level >= 0; level--) {
        cell *= 2;
        vec4 part; // 00, 10, 01, 11
        for (int i = 0; i < 4; i++)
            part[i] = texelFetch(importances, cell + ivec2(i & 1, i >> 1), level).r + least;
        int x = take_half(place.x, part[0] + part[2], part[1] + part[3]);
        cell += ivec2(x, take_half(place.y, part[x], part[x + 2]));
    }
    seed = texelFetch(numbers, cell, 0).r - 1.0;
}
