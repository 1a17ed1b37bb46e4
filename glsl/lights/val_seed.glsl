// VAL k starts as VPL k N / M, the same every frame [Dong 2009 §6]; of many as VPL k: Halton's first points are even,
// and those N / M apart are not where that is a power of two. Where that one met nothing, as the next one that did.
// With SEEDED as a VPL that is told, or nowhere.
#include "lib/vpl_texels.glsl"
#include "shared/cluster.h"

#if SEEDED
layout(binding = UNIT_SEEDS) uniform sampler2D seeds; // numbers; -1: none
#endif

bool has_seed(int k) {
#if SEEDED
    return texelFetch(seeds, ivec2(k, 0), 0).r > VAL_SEED_NOWHERE;
#else
    return true;
#endif
}

vpl seed_vpl(int k) {
#if METRIC == CLUSTER_METRIC_SQUARES
    int i = k % params.vpl_count;
#else
    int i = k * params.vpl_count / params.val_count;
#endif
#if SEEDED
    int told = int(texelFetch(seeds, ivec2(k, 0), 0).r);
    i = told < 0 ? i : told;
#endif
    for (int step = 0; step < params.vpl_count && vpl_at(i).reach == 0.0; step++)
        i = (i + 1) % params.vpl_count;
    return vpl_at(i);
}
