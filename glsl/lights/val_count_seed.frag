// VAL k begins at VPL k where as many VALs are needed, else nowhere: so many bring the mean distance down to the one
// asked for, as it falls with the root of their number.
#include "shared/cluster.h"

layout(binding = UNIT_SUMS) uniform sampler2D sums; // lights/val_count.vert

layout(location = TARGET_RESULT) out float seed;

void main() {
    vec2 sum = texelFetch(sums, ivec2(0), 0).xy;
    float over = sum.x / max(sum.y, 1e-30) / params.distortion;
    float count = max(round(float(VAL_PROBES) * over * over), 1.0);
    float k = floor(gl_FragCoord.x);
    seed = k < count ? k : VAL_SEED_NOWHERE;
}
