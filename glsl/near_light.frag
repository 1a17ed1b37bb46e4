// What each texel of the reflective shadow map reflects, for the near field: once for the texel, not for
// each of the many samples that meet it.
#include "lib/light.glsl"
#include "lib/near_light.glsl"
#include "lib/surface.glsl"
#include "shared/params.h"
#include "shared/vpl.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    near_field_params params;
};
layout(binding = UNIT_RSM_DEPTH) uniform sampler2DArray rsm_depths;
layout(binding = UNIT_RSM_NORMAL) uniform sampler2DArray rsm_normals;
layout(binding = UNIT_RSM_ALBEDO) uniform sampler2DArray rsm_albedos;

flat in int instance;

layout(location = TARGET_RESULT) out uvec4 packed_light;

void main() {
    packed_light = uvec4(0u);
    view v = light.views[instance];
    ivec3 texel = ivec3(gl_FragCoord.xy, instance);
    surface s = surface_fetch(v, rsm_depths, rsm_normals, texel);
    if (!s.present)
        return;
    bool directional = light_type() == LIGHT_TYPE_DIRECTIONAL;
    vec3 from_light = s.position - light.position.xyz;
    vec3 direction = directional ? v.forward.xyz : normalize(from_light);
    float cosine = dot(s.normal, -direction);
    float distance2 = directional ? 1.0 : dot(from_light, from_light);
    float area = params.vpl_share * distance2 / max(cosine, VPL_COSINE_MIN);
    vec3 power = directional ? light.intensity.rgb : light_intensity(direction);
    power *= albedo_fetch(rsm_albedos, texel) * (cosine > 0.0 ? params.power_scale : 0.0);
    packed_light = near_light_pack(near_light(texelFetch(rsm_depths, texel, 0).r,
                                              texelFetch(rsm_normals, texel, 0).rg, power,
                                              sqrt(area) * params.inverse_radius));
}
