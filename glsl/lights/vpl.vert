// Vertex i becomes VPL i: a direction of its light by a Halton point, the texel of the reflective shadow
// map that it meets, and the flux reflected there [Dong 2009 §4, §6].
#include "lib/rsm.glsl"
#include "lib/vpl_output.glsl"
#include "lib/vpl_shares.glsl"

layout(location = ATTRIBUTE_VPL_POINT) in vec3 halton_and_light;

const float PI = 3.14159265358979;

// Uniform in the solid angle of the cone (an area light's half space; the sphere, where cos outer is -1).
vec3 sample_direction(light l, vec2 halton) {
    float cos_outer = l.type == LIGHT_TYPE_SPOT ? l.cos_outer : l.type == LIGHT_TYPE_AREA ? 0.0 : -1.0;
    float z = mix(1.0, cos_outer, halton.x), azimuth = 2.0 * PI * halton.y;
    vec2 r = sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(azimuth), sin(azimuth));
    return r.x * l.right + r.y * l.up + z * l.direction;
}

// The VPL where the light meets that texel's surface; one without flux where it meets nothing.
vpl reflected(light l, vpl_share share, light_view view, ivec2 texel, vec3 direction) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    surface s = rsm_surface(view, texel);
    if (!s.present)
        return vpl(l.position, 0.0, -direction, 0.0, vec3(0.0), 0.0);
    vpl v = vpl(s.position, 0.0, s.normal, 0.0, vec3(0.0), 0.0);
    vec3 from_light = s.position - l.position;
    float distance2 = dot(from_light, from_light);
    vec3 incoming = directional ? direction : from_light * inversesqrt(distance2);
    float cosine = dot(s.normal, -incoming);
    if (cosine <= 0.0)
        return v;
    vec3 power = directional ? l.intensity : light_intensity(l, incoming) * light_in_range(l, distance2);
    v.flux = rsm_albedo(view, texel) * power * share.measure;
    v.area = share.measure * (directional ? 1.0 : distance2) / max(cosine, VPL_COSINE_MIN);
    v.reach = dot(v.flux, vec3(1.0)) > 0.0 ? share.reach : 0.0;
    return v;
}

void main() {
    int index = int(halton_and_light.z);
    vec2 halton = halton_and_light.xy;
    light l = light_at(index);
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 direction = l.direction;
    vec2 ndc = halton * 2.0 - 1.0;
    light_view view = light_view_at(l.first_view);
    if (!directional) {
        direction = sample_direction(l, halton);
        view = light_view_at(light_view_index(l, direction));
        vec4 clip = view.view.world_to_clip * vec4(direction, 0.0);
        ndc = clip.xy / clip.w;
    }
    ivec2 size = rsm_size(view.kind);
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
    vpl_output(reflected(l, vpl_share_at(index), view, texel, direction));
}
