// Direct light with a hard shadow map.
#include "lib/gbuffer.glsl"
#include "lib/light.glsl"
#include "shared/direct.h"
#include "visibility/lookup.glsl"

layout(location = TARGET_RESULT) out vec4 direct;

// The share that arrives.
float arriving(surface s, int layer) {
    receiver r;
    return project(light.views[layer], s.position, s.normal, r) ? lit(layer, r, 0.0) : 1.0;
}

// Irradiance per unit of intensity, times direct_scale.
float received(surface s, vec3 direction, float distance2) {
    float share = max(dot(s.normal, -direction), 0.0);
    if (light.type != LIGHT_TYPE_DIRECTIONAL)
        share *= light.direct_scale / distance2;
    if (light.type == LIGHT_TYPE_SPOT)
        share *= light_cone(dot(direction, light.direction));
    return share > 0.0 ? share * arriving(s, light_view_index(direction)) : 0.0;
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
