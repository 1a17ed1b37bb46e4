// The fraction of VPLs that a light takes by flux alone (passes/lights/vpl.h).
#include "lib/light.glsl"
#include "lib/vpl_shares.glsl"
#include "shared/importance_map.h"

float light_fraction(int i) {
    float measure = vpl_share_at(i).measure;
    return measure > 0.0 ? light_at(i).measure / (measure * params.vpls) : 0.0;
}
