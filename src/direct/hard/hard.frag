// Direct light with a hard shadow map.
#include "lib/gbuffer.glsl"
#include "lib/light.glsl"
#include "shared/direct.h"

layout(binding = UNIT_SHADOW_MAP) uniform sampler2DArray shadow_map;

layout(location = TARGET_RESULT) out vec4 direct;

// The four nearest texels compared, the results weighted: a hard shadow whose edge is not stepped.
float shadow_lookup(vec3 position, vec3 normal, int layer) {
    view v = light.views[layer];
    float z = dot(position - v.origin, v.forward);
    float texel = 2.0 * length(v.right) * (v.orthographic ? 1.0 : z) / params.shadow_size;
    vec3 lifted = position + normal * (params.bias * texel);
    vec4 clip = v.world_to_clip * vec4(lifted, 1.0);
    float lifted_z = dot(lifted - v.origin, v.forward);
    vec2 at = (clip.xy / clip.w * 0.5 + 0.5) * params.shadow_size - 0.5;
    ivec2 base = ivec2(floor(at));
    vec2 weight = at - vec2(base);
    vec4 lit;
    for (int i = 0; i < 4; i++) {
        ivec2 tap = clamp(base + ivec2(i & 1, i >> 1), ivec2(0), ivec2(params.shadow_size) - 1);
        float depth = texelFetch(shadow_map, ivec3(tap, layer), 0).r;
        lit[i] = depth <= 0.0 || lifted_z <= view_linear_depth(v, depth) ? 1.0 : 0.0;
    }
    vec2 row = mix(lit.xz, lit.yw, weight.x);
    return mix(row.x, row.y, weight.y);
}

// Irradiance per unit of intensity, times direct_scale.
float received(surface s, vec3 direction, float distance2) {
    float share = max(dot(s.normal, -direction), 0.0);
    if (light.type != LIGHT_TYPE_DIRECTIONAL)
        share *= light.direct_scale / distance2;
    if (light.type == LIGHT_TYPE_SPOT)
        share *= light_cone(dot(direction, light.direction));
    return share > 0.0 ? share * shadow_lookup(s.position, s.normal, light_view_index(direction))
                       : 0.0;
}

void main() {
    direct = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    vec3 to_light = light.position - s.position;
    float distance2 = dot(to_light, to_light);
    vec3 direction = light.type == LIGHT_TYPE_DIRECTIONAL ? light.direction
                                                          : -to_light * inversesqrt(distance2);
    direct.rgb = params.light * received(s, direction, distance2);
}
