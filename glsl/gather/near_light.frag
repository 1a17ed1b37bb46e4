// What each texel of the reflective shadow map reflects, for the near field: once for the texel, not for
// each of the many samples that meet it.
#include "gather/near_light.glsl"
#include "lib/rsm.glsl"
#include "shared/near_field.h"
#include "shared/vpl.h"

flat in int instance;

layout(location = TARGET_RESULT) out uvec4 packed_light;

void main() {
    packed_light = uvec4(0u);
    view v = light.views[instance];
    ivec3 texel = ivec3(gl_FragCoord.xy, instance);
    surface s = rsm_surface(texel);
    if (!s.present)
        return;
    bool directional = light.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 from_light = s.position - light.position;
    vec3 direction = directional ? v.forward : normalize(from_light);
    float cosine = dot(s.normal, -direction);
    float distance2 = directional ? 1.0 : dot(from_light, from_light);
    float area = params.vpl_share * distance2 / max(cosine, VPL_COSINE_MIN);
    vec3 power = directional ? light.intensity : light_intensity(direction);
    power *= rsm_albedo(texel) * (cosine > 0.0 ? params.power_scale : 0.0);
    packed_light = near_light_pack(near_light(texelFetch(rsm_depths, texel, 0).r,
                                              texelFetch(rsm_normals, texel, 0).rg, power,
                                              sqrt(area) * params.inverse_radius));
}
