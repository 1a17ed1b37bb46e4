// The visibility of each VAL at one point: pixel k is VAL k.
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    probe_params params;
};

layout(location = TARGET_RESULT) out float lit;

#include "lib/visibility.glsl"

void main() {
    lit = visibility(int(gl_FragCoord.x), params.position.xyz, params.normal.xyz);
}
