// The seeds of all VALs.
#include "lights/val_seed.glsl"

layout(location = TARGET_VAL_POSITION) out vec4 val_position;
layout(location = TARGET_VAL_NORMAL) out vec4 val_normal;
layout(location = TARGET_VAL_FLUX) out vec4 val_flux;

void main() {
    vpl seed = seed_vpl(int(gl_FragCoord.x));
    val_position = vec4(seed.position, 0.0);
    val_normal = vec4(seed.normal, 0.0);
    val_flux = vec4(seed.flux, 0.0);
}
