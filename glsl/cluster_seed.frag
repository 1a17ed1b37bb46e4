// The seeds of all VALs.
#include "lib/val_seed.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    cluster_params params;
};
layout(binding = UNIT_VPLS) uniform samplerBuffer vpls;

layout(location = TARGET_VAL_POSITION) out vec4 val_position;
layout(location = TARGET_VAL_NORMAL) out vec4 val_normal;
layout(location = TARGET_VAL_FLUX) out vec4 val_flux;

void main() {
    int i = seed_vpl(vpls, int(gl_FragCoord.x), int(params.val_count), int(params.vpl_count));
    val_position = vec4(texelFetch(vpls, 3 * i).xyz, 0.0);
    val_normal = vec4(texelFetch(vpls, 3 * i + 1).xyz, 0.0);
    val_flux = vec4(0.0);
}
