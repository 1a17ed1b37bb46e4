// What VPLs of each light stand for.
#include "lib/light.glsl"
#include "shared/vpl_share.h"

layout(std140, binding = BLOCK_VPL_SHARES) uniform vpl_share_uniforms {
    vec4 vpl_share_rows[LIGHTS_MAX];
};

vpl_share vpl_share_at(int light) {
    return vpl_share(vpl_share_rows[light].x, vpl_share_rows[light].y, 0.0, 0.0);
}

// The fraction of all VPLs that a light takes by flux alone (passes/lights/vpl.h).
float light_fraction(int i, float vpls) {
    float measure = vpl_share_at(i).measure;
    return measure > 0.0 ? light_at(i).measure / (measure * vpls) : 0.0;
}
