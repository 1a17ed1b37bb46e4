// The seeds of all VALs.
#include "lights/val_seed.glsl"

layout(location = TARGET_VAL_POSITION) out vec4 val_position;
layout(location = TARGET_VAL_NORMAL) out vec4 val_normal;
layout(location = TARGET_VAL_FLUX) out vec4 val_flux;

const float FAR_OFF = 1e15; // metres: nobody's nearest

void main() {
    int k = int(gl_FragCoord.x);
    vpl seed = seed_vpl(k);
    val_position = vec4(has_seed(k) ? seed.position : vec3(FAR_OFF), 0.0);
    val_normal = vec4(seed.normal, 0.0);
    val_flux = vec4(seed.flux, 0.0);
}
