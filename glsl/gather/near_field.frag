// The near field of the lit surfaces: what VPLs, a spacing apart, cannot resolve. Each pixel gathers from
// the reflective shadow map around its own place in each light's view [Dachsbacher and Stamminger 2005],
// log-polar, so that a corner is resolved at every distance. Unoccluded.
//     E = 1/n sum_j  rho I / pi  cos cos / d^2  near(d)  dw_j
// A draw fills one tile, whose pixels share their samples, as in the gather.
#include "lib/gbuffer.glsl"
#include "gather/near_field.glsl"
#include "gather/receiver.glsl"
#include "gather/near_light.glsl"
#include "lib/light.glsl"
#include "lib/vpl_shares.glsl"
#include "shared/near_field.h"
#include "shared/vpl.h"

layout(std140, binding = BLOCK_NEAR_SAMPLES) uniform sample_uniforms {
    vec4 sample_rows[NEAR_SAMPLES_MAX];
};
layout(binding = UNIT_NEAR_LIGHT) uniform usampler2DArray near_lights[LIGHT_MAP_KINDS];

layout(location = LOCATION_SLOT) uniform ivec4 slot; // first sample, count, the tile's place in the pattern
// The lights that this tile takes, and each one's weight: of a group of many one stands for all.
layout(location = LOCATION_PICK_COUNT) uniform int pick_count;
layout(location = LOCATION_PICKS) uniform vec2 picks[LIGHTS];

layout(location = TARGET_RESULT) out vec4 irradiance;

const float PI = 3.14159265358979;

// Of maps of the kind, texels a side.
int near_size(int kind) {
    return kind == LIGHT_MAP_FACE ? textureSize(near_lights[LIGHT_MAP_FACE], 0).x
                                  : textureSize(near_lights[LIGHT_MAP_SINGLE], 0).x;
}

near_light near_fetch(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return near_light_unpack(v.kind == LIGHT_MAP_FACE
                                 ? texelFetch(near_lights[LIGHT_MAP_FACE], place, 0)
                                 : texelFetch(near_lights[LIGHT_MAP_SINGLE], place, 0));
}

// What reaches the receiver from where the light's view of that number has the point `ndc`, per unit of
// ndc area and spread of the view.
vec3 sample_light(surface receiver, light l, int index, vec2 ndc, float reach) {
    light_view seen = light_view_at(index);
    view v = seen.view;
    float measure = 1.0;
#if MAP_KINDS & (1 << LIGHT_MAP_FACE)
    // The point may lie beyond the edge of a cube's face: another face has it, and its own solid angle per unit of its ndc area.
    // Both are the cube of the ray's cosine.
    vec3 ray = v.forward + ndc.x * v.right + ndc.y * v.up;
    int other = light_view_index(l, ray);
    seen = light_view_at(other);
    v = seen.view;
    if (other != index) {
        vec4 clip = v.world_to_clip * vec4(ray, 0.0);
        ndc = clip.xy / clip.w;
        measure = 1.0 / (clip.w * clip.w * clip.w);
    }
#endif
    vec2 size = vec2(near_size(seen.kind));
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * size), ivec2(0), ivec2(size) - 1);
    near_light near = near_fetch(seen, texel);
    vec3 position = view_position_at(v, (vec2(texel) + 0.5) / size * 2.0 - 1.0, near.z);
    vec3 to_sample = (position - receiver.position) * params.inverse_radius;
    float distance2 = dot(to_sample, to_sample);
    float cosines = max(dot(receiver.normal, to_sample), 0.0) *
                    max(-dot(octahedral_decode(near.normal_code), to_sample), 0.0);
    float share = near_share(distance2, near.spacing * near.spacing, reach);
    // No branches: a software rasteriser executes both sides.
    bool seen_lit = all(lessThan(abs(ndc), vec2(1.0))) && near.z > 0.0 && cosines > 0.0;
    return near.power * (seen_lit ? cosines / (distance2 * distance2) * share * measure : 0.0);
}

// Of one light, where there is something that receives it.
vec3 near_field(surface s, bool receives, light l, vpl_share share) {
    int index = light_view_index(l, s.position - l.position);
    light_view seen = light_view_at(index);
    view v = seen.view;
    vec4 clip = v.world_to_clip * vec4(s.position, 1.0);
    vec2 center = clip.xy / clip.w;
    // The reach of the widest VPL, in ndc.
    float radius = share.reach * sqrt(share.measure / VPL_COSINE_MIN) / length(v.right);
    vec2 aspect = vec2(1.0, length(v.right) / length(v.up));
    float least = 1.0 / float(near_size(seen.kind)), span = log(radius / least);
    // A count and no branch around the loop, which a software rasteriser would keep books of at each step.
    bool reached = receives && clip.w > 0.0 && all(lessThanEqual(abs(center), vec2(1.0 + radius))) && span > 0.0;
    int last = reached ? slot.x + slot.y : slot.x;
    vec3 sum = vec3(0.0);
    for (int i = slot.x; i < last; i++) {
        near_sample place = near_sample(sample_rows[i].xy, sample_rows[i].z, 0.0);
        float r = least * exp(span * place.log_radius);
        // Log-polar density: 1 / (2 pi r^2 span) per ndc area.
        vec2 ndc = center + r * place.direction * aspect;
        sum += sample_light(s, l, index, ndc, share.reach) * (r * r);
    }
    float spread = length(v.right) * length(v.up);
    float weight = 2.0 * PI * span * aspect.y * spread / float(slot.y);
    return reached ? sum * (weight / PI) : vec3(0.0);
}

void main() {
    irradiance = vec4(0.0);
    ivec2 pixel;
    bool receives = receiver_pixel(params.pattern, slot.zw, pixel);
    surface s = receiver_surface(pixel);
    receives = receives && s.present;
#if LIGHTS == 1 // or none
    irradiance.rgb = near_field(s, receives && pick_count > 0, light_at(0), vpl_share_at(0));
#else
    for (int i = 0; i < pick_count; i++) {
        int index = int(picks[i].x);
        irradiance.rgb += picks[i].y * near_field(s, receives, light_at(index), vpl_share_at(index));
    }
#endif
}
