// The near field of the lit surfaces: what VPLs, a spacing apart, cannot resolve. Each pixel gathers from
// the reflective shadow map around its own place in the light's view [Dachsbacher and Stamminger 2005],
// log-polar, so that a corner is resolved at every distance. Unoccluded.
//     E = 1/n sum_j  rho I / pi  cos cos / d^2  near(d)  dw_j
// A draw fills one tile, whose pixels share their samples, as in the gather.
#include "lib/gbuffer.glsl"
#include "lib/interleaving.glsl"
#include "lib/light.glsl"
#include "gather/near_field.glsl"
#include "gather/near_light.glsl"
#include "shared/near_field.h"
#include "shared/vpl.h"

layout(std140, binding = BLOCK_NEAR_SAMPLES) uniform sample_uniforms {
    near_sample samples[NEAR_SAMPLES_MAX];
};
layout(binding = UNIT_NEAR_LIGHT) uniform usampler2DArray near_lights;

layout(location = LOCATION_SLOT) uniform ivec4 slot; // first sample, count, the tile's place in the pattern

layout(location = TARGET_RESULT) out vec4 irradiance;

const float PI = 3.14159265358979;

// The view that sees a direction: where there is but one it is known beforehand, and need not be looked
// up pixel by pixel.
int seen_by(vec3 direction) {
#if LIGHT_VIEWS == 1
    return 0;
#else
    return light_view_index(direction);
#endif
}

// What reaches the receiver from where the light's view has the point `ndc`, per unit of ndc area and
// spread of the view.
vec3 sample_light(surface receiver, view v, int layer, vec2 ndc) {
    vec3 ray = v.forward + ndc.x * v.right + ndc.y * v.up;
    // Solid angle per unit of ndc area, but for the view's own spread; an area does not depend on the ray.
    float stretch = inversesqrt(dot(ray, ray));
    float measure = v.orthographic ? 1.0 : stretch * stretch * stretch;
#if LIGHT_VIEWS > 1
    // The point may lie beyond the edge of a cube's face: another face has it.
    int own = layer;
    layer = seen_by(ray);
    v = light.views[layer];
    if (layer != own) {
        vec4 clip = v.world_to_clip * vec4(light.position + ray, 1.0);
        ndc = clip.xy / clip.w;
    }
#endif
    if (any(greaterThanEqual(abs(ndc), vec2(1.0))))
        return vec3(0.0);
    vec2 size = vec2(textureSize(near_lights, 0).xy);
    ivec2 texel = ivec2((ndc * 0.5 + 0.5) * size);
    near_light l = near_light_unpack(texelFetch(near_lights, ivec3(texel, layer), 0));
    if (l.depth <= 0.0)
        return vec3(0.0);
    vec3 position = view_position(v, (vec2(texel) + 0.5) / size * 2.0 - 1.0, l.depth);
    vec3 to_sample = (position - receiver.position) * params.inverse_radius;
    float distance2 = dot(to_sample, to_sample);
    float cosines = max(dot(receiver.normal, to_sample), 0.0) *
                    max(-dot(octahedral_decode(l.normal_code), to_sample), 0.0);
    if (cosines <= 0.0)
        return vec3(0.0);
    float near = near_share(distance2, l.spacing * l.spacing, params.reach);
    return l.power * (cosines / (distance2 * distance2) * near * measure);
}

void main() {
    irradiance = vec4(0.0);
    ivec2 pixel = interleaved_pixel(params.pattern, ivec2(gl_FragCoord.xy), slot.zw);
    surface s = gbuffer_surface(pixel);
    if (!s.present)
        return;
    int layer = seen_by(s.position - light.position);
    view v = light.views[layer];
    vec4 clip = v.world_to_clip * vec4(s.position, 1.0);
    if (clip.w <= 0.0)
        return;
    vec2 center = clip.xy / clip.w;
    // The reach of the widest VPL, in ndc.
    float radius = params.reach * sqrt(params.vpl_share / VPL_COSINE_MIN) / length(v.right);
    if (any(greaterThan(abs(center), vec2(1.0 + radius))))
        return;
    vec2 aspect = vec2(1.0, length(v.right) / length(v.up));
    float least = 1.0 / float(textureSize(near_lights, 0).x), span = log(radius / least);
    if (span <= 0.0)
        return;
    vec3 sum = vec3(0.0);
    for (int i = slot.x; i < slot.x + slot.y; i++) {
        float r = least * exp(span * samples[i].log_radius);
        // Log-polar density: 1 / (2 pi r^2 span) per ndc area.
        sum += sample_light(s, v, layer, center + r * samples[i].direction * aspect) * (r * r);
    }
    float spread = length(v.right) * length(v.up);
    float weight = 2.0 * PI * span * aspect.y * spread / float(slot.y);
    irradiance = vec4(sum * (weight / PI), 1.0);
}
