// Vertex i becomes VPL i: a direction of the light by Halton point i, the texel of the reflective
// shadow map that it meets, and the flux reflected there [Dong 2009 §4, §6].
#include "lib/light.glsl"
#include "lib/surface.glsl"

#include "shared/vpl.h"

layout(location = ATTRIBUTE_HALTON) in vec2 halton;
layout(location = LOCATION_VPL_COUNT) uniform int vpl_count;

layout(binding = UNIT_RSM_DEPTH) uniform sampler2DArray depths;
layout(binding = UNIT_RSM_NORMAL) uniform sampler2DArray normals;
layout(binding = UNIT_RSM_ALBEDO) uniform sampler2DArray albedos;

out vec4 vpl_position, vpl_normal, vpl_flux;

const float PI = 3.14159265358979;

// Uniform in the solid angle of the cone (of the sphere, where cos outer is -1).
vec3 sample_direction() {
    float cos_outer = light_type() == LIGHT_TYPE_SPOT ? light.up.w : -1.0;
    float z = mix(1.0, cos_outer, halton.x), azimuth = 2.0 * PI * halton.y;
    vec2 r = sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(azimuth), sin(azimuth));
    return r.x * light.right.xyz + r.y * light.up.xyz + z * light.direction.xyz;
}

void main() {
    bool directional = light_type() == LIGHT_TYPE_DIRECTIONAL;
    vec3 direction = light.direction.xyz;
    vec2 ndc = halton * 2.0 - 1.0;
    int layer = 0;
    if (!directional) {
        direction = sample_direction();
        layer = light_view_index(direction);
        vec4 clip = light.views[layer].world_to_clip * vec4(light.position.xyz + direction, 1.0);
        ndc = clip.xy / clip.w;
    }
    ivec2 size = textureSize(depths, 0).xy;
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
    surface s = surface_fetch(light.views[layer], depths, normals, ivec3(texel, layer));
    vec3 albedo = albedo_fetch(albedos, ivec3(texel, layer));

    vpl_position = vec4(s.present ? s.position : light.position.xyz, 0.0);
    vpl_normal = vec4(s.present ? s.normal : -direction, 0.0);
    vpl_flux = vec4(0.0);
    if (!s.present)
        return;
    vec3 from_light = s.position - light.position.xyz;
    float distance2 = dot(from_light, from_light);
    vec3 incoming = directional ? direction : from_light * inversesqrt(distance2);
    float cosine = dot(s.normal, -incoming);
    if (cosine <= 0.0)
        return;
    // The share of one sample: solid angle of a spot or point light, area across a directional one.
    float share = light.intensity.w / float(vpl_count);
    vec3 power = directional ? light.intensity.rgb : light_intensity(incoming);
    vpl_flux = vec4(albedo * power * share, 1.0);
    vpl_normal.w = share * (directional ? 1.0 : distance2) / max(cosine, VPL_COSINE_MIN);
    if (dot(vpl_flux.rgb, vec3(1.0)) <= 0.0)
        vpl_flux.w = 0.0;
}
