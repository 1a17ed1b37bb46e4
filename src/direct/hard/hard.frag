// Direct light with a hard shadow map, of one light.
#include "lib/gbuffer.glsl"
#include "lib/unshadowed.glsl"
#include "visibility/lookup.glsl"

layout(location = LOCATION_LIGHT) uniform int light_index;

layout(location = TARGET_RESULT) out vec4 direct;

// The share that arrives.
float arriving(surface s, light_view v) {
    receiver r;
    return project(v.view, s.position, s.normal, r) ? lit(v.layer, r, 0.0) : 1.0;
}

// Irradiance per unit of intensity, times direct_scale.
float received(surface s, light l, vec3 direction, float distance2) {
    float share = unshadowed(l, s.position, s.normal, direction, distance2);
    return share > 0.0 ? share * arriving(s, light_view_at(light_view_index(l, direction))) : 0.0;
}

void main() {
    direct = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    light l = light_at(light_index);
    vec3 to_light = l.position - s.position;
    float distance2 = dot(to_light, to_light);
    vec3 direction = l.type == LIGHT_TYPE_DIRECTIONAL ? l.direction : -to_light * inversesqrt(distance2);
    direct.rgb = l.radiance * received(s, l, direction, distance2);
}
