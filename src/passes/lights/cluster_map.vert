// The mapping C: each VPL is written again with the number of its VAL [Dong 2009 §6].
#include "shared/cluster.h"
#include "passes/lights/val_distance.glsl"
#include "lib/vpl_input.glsl"
#include "lib/vpl_output.glsl"

void main() {
    vpl v = vpl_input();
    v.val = float(nearest_val(v));
    vpl_output(v);
}
