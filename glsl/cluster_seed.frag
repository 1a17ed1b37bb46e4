// VAL k starts as VPL k N / M, the same every frame [Dong 2009 §6]; where that one met nothing, as the
// next one that did.
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    cluster_params params;
};
layout(binding = 0) uniform samplerBuffer vpls; // three texels a VPL: position, normal, flux

layout(location = 0) out vec4 val_position;
layout(location = 1) out vec4 val_normal;
layout(location = 2) out vec4 val_flux;

void main() {
    int count = int(params.vpl_count);
    int start = int(gl_FragCoord.x) * count / int(params.val_count), i = start;
    for (int step = 0; step < count && texelFetch(vpls, 3 * i + 2).w == 0.0; step++)
        i = (i + 1) % count;
    val_position = vec4(texelFetch(vpls, 3 * i).xyz, 0.0);
    val_normal = vec4(texelFetch(vpls, 3 * i + 1).xyz, 0.0);
    val_flux = vec4(0.0);
}
