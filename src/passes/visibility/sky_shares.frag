// What four lights of a sky give a surface that nothing hides from them, irradiance over radiance, by its
// normal: octahedral, the middles of the outer texels on the edge. The layer after them has the luminance of all lights.
#include "lib/direction.glsl"
#include "lib/sky.glsl"
#include "shared/sky.h"

PASS_BLOCK(environment_lighting_params, 32)

flat in int instance;

layout(location = TARGET_RESULT) out vec4 shares;

void main() {
    vec3 normal = octahedral_decode((gl_FragCoord.xy - 0.5) / float(SKY_SHARES_SIZE - 1));
    shares = vec4(0.0);
    for (int k = 0; k < SKY_LAYER_LIGHTS; k++)
        if (SKY_LAYER_LIGHTS * instance + k < params.count)
            shares[k] = sky_irradiance(SKY_LAYER_LIGHTS * instance + k, normal);
    if (SKY_LAYER_LIGHTS * instance >= params.count)
        for (int i = 0; i < params.count; i++)
            shares.r += sky_irradiance(i, normal) * sky_radiance(i).a;
}
