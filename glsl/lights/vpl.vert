// Vertex i becomes VPL i: a direction of the light by Halton point i, the texel of the reflective
// shadow map that it meets, and the flux reflected there [Dong 2009 §4, §6].
#include "lib/rsm.glsl"
#include "lib/vpl_output.glsl"
#include "shared/vpl_pass.h"

layout(location = ATTRIBUTE_HALTON) in vec2 halton;

const float PI = 3.14159265358979;

// Uniform in the solid angle of the cone (of the sphere, where cos outer is -1).
vec3 sample_direction() {
    float cos_outer = light.type == LIGHT_TYPE_SPOT ? light.cos_outer : -1.0;
    float z = mix(1.0, cos_outer, halton.x), azimuth = 2.0 * PI * halton.y;
    vec2 r = sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(azimuth), sin(azimuth));
    return r.x * light.right + r.y * light.up + z * light.direction;
}

// The VPL where the light meets that texel's surface; one without flux where it meets nothing.
vpl reflected(ivec3 texel, vec3 direction) {
    bool directional = light.type == LIGHT_TYPE_DIRECTIONAL;
    surface s = rsm_surface(texel);
    if (!s.present)
        return vpl(light.position, 0.0, -direction, 0.0, vec3(0.0), 0.0);
    vpl v = vpl(s.position, 0.0, s.normal, 0.0, vec3(0.0), 0.0);
    vec3 from_light = s.position - light.position;
    float distance2 = dot(from_light, from_light);
    vec3 incoming = directional ? direction : from_light * inversesqrt(distance2);
    float cosine = dot(s.normal, -incoming);
    if (cosine <= 0.0)
        return v;
    // The share of one sample: solid angle of a spot or point light, area across a directional one.
    float share = light.measure / float(params.count);
    vec3 power = directional ? light.intensity : light_intensity(incoming);
    v.flux = rsm_albedo(texel) * power * share;
    v.area = share * (directional ? 1.0 : distance2) / max(cosine, VPL_COSINE_MIN);
    v.emits = dot(v.flux, vec3(1.0)) > 0.0 ? 1.0 : 0.0;
    return v;
}

void main() {
    bool directional = light.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 direction = light.direction;
    vec2 ndc = halton * 2.0 - 1.0;
    int layer = 0;
    if (!directional) {
        direction = sample_direction();
        layer = light_view_index(direction);
        vec4 clip = light.views[layer].world_to_clip * vec4(light.position + direction, 1.0);
        ndc = clip.xy / clip.w;
    }
    ivec2 size = textureSize(rsm_depths, 0).xy;
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
    vpl_output(reflected(ivec3(texel, layer), direction));
}
