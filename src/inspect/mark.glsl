// Marks in the scene: points and lines over its picture.
#include "lib/vpl_rows.glsl"
#include "lib/gbuffer.glsl"
#include "shared/inspect.h"

PASS_BLOCK(mark_params, 32)

// How strongly a VAL is drawn.
float cluster_strength(int k) {
    if (params.chosen < 0 || k == params.chosen)
        return 1.0;
    return params.only_chosen ? 0.0 : 0.25;
}
