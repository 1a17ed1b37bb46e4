// VAL k starts as VPL k N / M, the same every frame [Dong 2009 §6]; where that one met nothing, as the
// next one that did.
#include "lib/vpl_texels.glsl"
#include "shared/cluster.h"

vpl seed_vpl(int k) {
    int i = k * params.vpl_count / params.val_count;
    for (int step = 0; step < params.vpl_count && vpl_at(i).reach == 0.0; step++)
        i = (i + 1) % params.vpl_count;
    return vpl_at(i);
}
