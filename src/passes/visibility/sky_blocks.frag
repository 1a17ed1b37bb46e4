// The visibility of four lights of a sky at the centre of each block; of what is below the horizon, 1.
#include "shared/sky.h"

PASS_BLOCK(environment_lighting_params, 32)

#include "passes/gather/block.glsl"
#include "passes/visibility/sky_visibility.glsl"

flat in int instance;

layout(location = TARGET_RESULT) out vec4 visible;

void main() {
    surface s = gbuffer_surface(block_center(ivec2(gl_FragCoord.xy)));
    visible = vec4(1.0);
    if (!s.present)
        return;
    vec4 shares = sky_shares(s.normal, instance);
    for (int k = 0; k < 4; k++)
        if (shares[k] > 0.0)
            visible[k] = sky_visibility(4 * instance + k, s.position, s.normal);
}
