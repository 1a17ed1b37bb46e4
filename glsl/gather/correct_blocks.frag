// The veil over the visibility of each block.
#include "shared/bindings.h"
#include "shared/correction.h"
#include "gather/correction.glsl"
#include "lib/gbuffer.glsl"

flat in int instance;

layout(location = TARGET_RESULT) out vec4 veil;

void main() {
    vec2 center = gl_FragCoord.xy * float(params.block);
    veil = correction_veil(correction_at(instance, center / vec2(gbuffer_size())).g).xxxy;
}
