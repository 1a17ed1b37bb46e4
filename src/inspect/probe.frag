// The visibility of each VAL at one point: pixel k is VAL k.
#include "passes/visibility/visibility.glsl"
#include "shared/inspect.h"

PASS_BLOCK(probe_params, 32)

layout(location = TARGET_RESULT) out float visible;

void main() {
    visible = visibility(int(gl_FragCoord.x), params.position, params.normal);
}
