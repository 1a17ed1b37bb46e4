// The near field of the lit surfaces: what VPLs, a spacing apart, cannot resolve. Each pixel gathers from
// the reflective shadow map around its own place in the light's view [Dachsbacher and Stamminger 2005],
// log-polar, so that a corner is resolved at every distance. Unoccluded.
//     E = 1/n sum_j  rho I / pi  cos cos / d^2  near(d)  dw_j
// A draw fills one tile, whose pixels share their samples, as in the gather.
#include "lib/light.glsl"
#include "lib/near_field.glsl"
#include "lib/surface.glsl"
#include "shared/params.h"
#include "shared/vpl.h"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    near_field_params params;
};
layout(std140, binding = BLOCK_VPLS) uniform sample_uniforms {
    vec4 samples[NEAR_SAMPLES_MAX]; // x: log radius in [0, 1], y: turn in [0, 1]
};
layout(binding = 0) uniform sampler2DArray depths;
layout(binding = 1) uniform sampler2DArray normals;
layout(binding = 2) uniform sampler2DArray rsm_depths;
layout(binding = 3) uniform sampler2DArray rsm_normals;
layout(binding = 4) uniform sampler2DArray rsm_albedos;

layout(location = 0) uniform ivec4 slot; // first sample, count, the tile's place in the pattern

layout(location = 0) out vec4 irradiance;

const float PI = 3.14159265358979;

// What reaches the receiver from where the light's view has the point `ndc`, per unit of ndc area.
vec3 sample_light(surface receiver, view v, int layer, vec2 ndc) {
    bool directional = v.right.w > 0.5;
    vec3 ray = v.forward.xyz + ndc.x * v.right.xyz + ndc.y * v.up.xyz;
    float length2 = dot(ray, ray);
    // The point may lie beyond the edge of a cube's face: another face has it.
    int seen_by = directional ? layer : light_view_index(ray);
    view w = light.views[seen_by];
    if (seen_by != layer) {
        vec4 clip = w.world_to_clip * vec4(light.position.xyz + ray, 1.0);
        ndc = clip.xy / clip.w;
    }
    if (any(greaterThanEqual(abs(ndc), vec2(1.0))))
        return vec3(0.0);
    ivec3 texel = ivec3((ndc * 0.5 + 0.5) * vec2(textureSize(rsm_depths, 0).xy), seen_by);
    surface s = surface_fetch(w, rsm_depths, rsm_normals, texel);
    if (!s.present)
        return vec3(0.0);
    vec3 to_sample = s.position - receiver.position;
    float distance2 = dot(to_sample, to_sample);
    float cosines = max(dot(receiver.normal, to_sample), 0.0) * max(-dot(s.normal, to_sample), 0.0);
    if (cosines <= 0.0)
        return vec3(0.0);
    vec3 direction = directional ? v.forward.xyz : ray * inversesqrt(length2);
    float cosine = dot(s.normal, -direction);
    if (cosine <= 0.0)
        return vec3(0.0);
    float from_light = directional ? 1.0 : dot(s.position - light.position.xyz, s.position - light.position.xyz);
    float area = params.vpl_share * from_light / max(cosine, VPL_COSINE_MIN);
    float geometry = cosines / (distance2 * distance2) * near_share(distance2, area, params.reach);
    // Solid angle (for a directional light, area) per unit of ndc area.
    float spread = length(v.right.xyz) * length(v.up.xyz);
    float measure = directional ? spread : spread / (length2 * sqrt(length2));
    vec3 power = directional ? light.intensity.rgb : light_intensity(direction);
    return albedo_fetch(rsm_albedos, texel) * power * (geometry * measure);
}

void main() {
    irradiance = vec4(0.0);
    ivec2 tile = slot.zw;
    ivec2 origin = tile * ivec2(params.tile_width, params.tile_height);
    ivec2 pixel = (ivec2(gl_FragCoord.xy) - origin) * int(params.interleave) + tile;
    surface s = surface_fetch(camera, depths, normals, ivec3(pixel, 0));
    if (!s.present)
        return;
    bool directional = light_type() == LIGHT_TYPE_DIRECTIONAL;
    int layer = directional ? 0 : light_view_index(s.position - light.position.xyz);
    view v = light.views[layer];
    vec4 clip = v.world_to_clip * vec4(s.position, 1.0);
    if (clip.w <= 0.0)
        return;
    vec2 center = clip.xy / clip.w;
    // The reach of the widest VPL, in ndc.
    float radius = params.reach * sqrt(params.vpl_share / VPL_COSINE_MIN) / length(v.right.xyz);
    if (any(greaterThan(abs(center), vec2(1.0 + radius))))
        return;
    vec2 aspect = vec2(1.0, length(v.right.xyz) / length(v.up.xyz));
    float least = 1.0 / float(textureSize(rsm_depths, 0).x), span = log(radius / least);
    if (span <= 0.0)
        return;
    vec3 sum = vec3(0.0);
    for (int i = slot.x; i < slot.x + slot.y; i++) {
        float r = least * exp(span * samples[i].x), turn = 2.0 * PI * samples[i].y;
        vec2 ndc = center + r * vec2(cos(turn), sin(turn)) * aspect;
        // Log-polar density: 1 / (2 pi r^2 span) per ndc area.
        sum += sample_light(s, v, layer, ndc) * (r * r);
    }
    float weight = 2.0 * PI * span * aspect.y / float(slot.y);
    irradiance = vec4(sum * (weight * params.scale / PI), 1.0);
}
