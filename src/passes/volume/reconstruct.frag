// The volume's light, or its visibility in [0, 1], at each pixel; alpha is 0 where no voxel knows.
#include "lib/gbuffer.glsl"
#include "passes/volume/irradiance.glsl"

layout(location = TARGET_RESULT) out vec4 result;

void main() {
    result = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    vec3 irradiance;
    bool known = volume_irradiance(volume_place(s.position), s.normal, irradiance);
#if CHANNELS == VOLUME_VISIBILITY
    irradiance = params.irradiance_scale * min(irradiance / 3.1415927, 1.0);
#endif
    result = vec4(irradiance, known ? 1.0 : 0.0);
}
