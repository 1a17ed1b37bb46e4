// Direct light of one light, at the G-buffer. Who includes it says which share of the light arrives:
float arriving(surface s, light l, vec3 direction);

layout(location = LOCATION_LIGHT) uniform int light_index;

layout(location = TARGET_RESULT) out vec4 direct;

void main() {
    direct = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    light l = light_at(light_index);
    vec3 to_light = l.position - s.position;
    float distance2 = dot(to_light, to_light);
    vec3 direction = l.type == LIGHT_TYPE_DIRECTIONAL ? l.direction : -to_light * inversesqrt(distance2);
    float share = unshadowed(l, s.position, s.normal, direction, distance2);
    direct.rgb = l.radiance * (share > 0.0 ? share * arriving(s, l, direction) : 0.0);
}
