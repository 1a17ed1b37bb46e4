// The layers of a picture, from the buffers of the frame.
#include "shared/composite.h"
#include "lib/gbuffer.glsl"
#include "lib/tiles.glsl"
#include "passes/picture/layer_shown.glsl"
#include "lib/edge_sample.glsl"

// What smooth surfaces throw onto this one: radiance of a white surface. A smooth surface itself has there what it shows,
// radiance, and in A 1 and the part of it that is indirect light (passes/caustics/glass.h).
#ifdef HAS_CAUSTICS
layout(binding = UNIT_CAUSTIC) uniform sampler2D caustics;

vec4 smooth_light(ivec2 texel) {
    return texelFetch(caustics, texel, 0);
}
#else
vec4 smooth_light(ivec2 texel) {
    return vec4(0.0);
}
#endif

struct smooth_seen {
    vec3 caustic, direct, indirect; // the last two: what it shows
    float rough;                    // 0: it is smooth, and reflects no other light; else 1
};

smooth_seen smooth_at(ivec2 texel) {
    vec4 light = smooth_light(texel);
    float rough = light.a > 0.0 ? 0.0 : 1.0;
    vec3 shown = (1.0 - rough) * light.rgb;
    return smooth_seen(rough * light.rgb, (2.0 - light.a) * shown, (light.a - 1.0) * shown, rough);
}

// The radiance of a surface beside its diffuse part.
#ifdef HAS_SPECULAR
layout(binding = UNIT_DIRECT_SPECULAR) uniform sampler2D direct_speculars;

vec3 direct_specular(ivec2 texel) {
    return texelFetch(direct_speculars, texel, 0).rgb;
}
#else
vec3 direct_specular(ivec2 texel) {
    return vec3(0.0);
}
#endif

// Not of light that comes straight from a source.
#ifdef HAS_RADIANCE
layout(binding = UNIT_RADIANCE) uniform sampler2D radiances;

vec3 indirect_specular(ivec2 texel) {
    return params.scale * texelFetch(radiances, texel, 0).rgb;
}
#else
vec3 indirect_specular(ivec2 texel) {
    return vec3(0.0);
}
#endif

#ifdef HAS_EMISSION
layout(binding = UNIT_GBUFFER_EMISSION) uniform sampler2DArray emissions;

vec3 emitted(ivec2 texel) {
    return params.scale * texelFetch(emissions, ivec3(texel, 0), 0).rgb;
}
#else
vec3 emitted(ivec2 texel) {
    return vec3(0.0);
}
#endif

// What lies behind all surfaces, and between them and the camera.
#ifdef HAS_SKY
#include "lib/direction.glsl"

layout(binding = UNIT_SKY) uniform sampler2D sky;

vec3 sky_radiance(ivec2 pixel) {
    vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(gbuffer_size()) - 1.0;
    vec3 along = camera.forward;
    if (!camera.orthographic)
        along += ndc.x * camera.right + ndc.y * camera.up;
    return params.sky_strength * panorama_texel(sky, along, params.sky_turn);
}

vec3 background(ivec2 pixel) {
    return params.sky_strength > 0.0 ? sky_radiance(pixel) : vec3(0.0);
}
#else
vec3 background(ivec2 pixel) {
    return vec3(0.0);
}
#endif

// Of light rays through smooth surfaces, in the medium.
#ifdef HAS_VOLUME_CAUSTICS
layout(binding = UNIT_VOLUME_CAUSTIC) uniform sampler2D volume_caustics;

vec3 volume_caustic(ivec2 texel) {
    return texelFetch(volume_caustics, texel, 0).rgb;
}
#else
vec3 volume_caustic(ivec2 texel) {
    return vec3(0.0);
}
#endif

// A medium on the way from surface to camera.
#ifdef HAS_MEDIUM
layout(binding = UNIT_IN_SCATTER) uniform sampler2D in_scatters;
layout(binding = UNIT_TRANSMITTANCE) uniform sampler2D transmittances;

vec3 airlight(ivec2 texel) {
    return params.scale * texelFetch(in_scatters, texel, 0).rgb;
}

vec3 through_medium(vec3 radiance, ivec2 texel) {
    return radiance * texelFetch(transmittances, texel, 0).rgb + airlight(texel) + volume_caustic(texel);
}

// The part of the light from behind that panes keep back.
float pane_opacity(ivec2 texel) {
    return 1.0 - texelFetch(transmittances, texel, 0).a;
}
#else
float pane_opacity(ivec2 texel) {
    return 0.0;
}

vec3 airlight(ivec2 texel) {
    return vec3(0.0);
}

vec3 through_medium(vec3 radiance, ivec2 texel) {
    return radiance;
}
#endif

// The irradiance of a technique that has it.
#ifdef HAS_IRRADIANCE
layout(binding = UNIT_IRRADIANCE) uniform sampler2D irradiances;

vec3 irradiance_of_pixel(ivec2 texel) {
    return texelFetch(irradiances, texel, 0).rgb;
}
#else
vec3 irradiance_of_pixel(ivec2 texel) {
    return vec3(0.0);
}
#endif

// At a sample's pixel, or at the edge sample of the pixel that has the sample.
#ifdef HAS_EDGE_SAMPLES
layout(binding = UNIT_EDGE_SAMPLE_TEXELS) uniform usampler2D edge_sample_texels;
layout(binding = UNIT_EDGE_SAMPLE_IRRADIANCE) uniform sampler2D edge_sample_irradiance;

vec3 irradiance_at(ivec2 texel, bool is_edge_sample, ivec2 pixel) {
    if (!is_edge_sample)
        return irradiance_of_pixel(texel);
    ivec2 place = list_texel_of(texelFetch(edge_sample_texels, pixel, 0).r);
    return texelFetch(edge_sample_irradiance, place, 0).rgb;
}
#else
vec3 irradiance_at(ivec2 texel, bool is_edge_sample, ivec2 pixel) {
    return irradiance_of_pixel(texel);
}
#endif

layout(binding = UNIT_GBUFFER_ALBEDO) uniform sampler2DArray albedos;
layout(binding = UNIT_DIRECT) uniform sampler2D directs;
layout(binding = UNIT_SAMPLE_ASSIGNMENT) uniform usampler2D sample_assignment;
layout(binding = UNIT_EDGE_SAMPLES) uniform usampler2D edge_samples;

// What the pixel sees, the mean over its samples. Light is irradiance over pi, the radiance of a
// white surface; weighted by the albedo, so that albedo (direct + indirect) = radiance at edges too.
// Specular is radiance.
struct seen {
    float coverage, opacity; // by surfaces, by panes too
    vec3 albedo, direct, indirect, radiance, direct_specular, indirect_specular, airlight, caustic, volume;
};

vec3 radiance_of(vec3 albedo, vec3 received, smooth_seen shown, ivec2 texel) {
    if (gbuffer_depth(texel) == 0.0)
        return through_medium(background(texel), texel);
    vec3 radiance = albedo * received + direct_specular(texel) + emitted(texel) + indirect_specular(texel);
    return through_medium(radiance + shown.direct + shown.indirect, texel);
}

uvec2 assignment_at(ivec2 pixel) {
    return texelFetch(sample_assignment, min(pixel, textureSize(sample_assignment, 0) - 1), 0).rg;
}

seen seen_by(uvec2 assignment, ivec2 pixel) {
    ivec2 last = gbuffer_size() - 1;
    int count = assignment == uvec2(0u) ? 1 : params.samples;
    seen sum = seen(0.0, 0.0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0),
                    vec3(0.0));
    vec3 weights = vec3(0.0);
    uint stand_in = 0u;
    if (has_edge_sample(assignment))
        stand_in = texelFetch(edge_samples, pixel, 0).w;
    for (int i = 0; i < count; i++) {
        uint assigned = assigned_to(assignment, i);
        if (assigned == ASSIGNED_NOTHING) {
            sum.opacity += pane_opacity(pixel);
            sum.radiance += through_medium(background(pixel), pixel);
            sum.airlight += airlight(pixel);
            sum.volume += volume_caustic(pixel);
            continue;
        }
        bool is_edge_sample = assigned == ASSIGNED_EDGE_SAMPLE;
        ivec2 texel = clamp(pixel + assigned_offset(is_edge_sample ? stand_in : assigned), ivec2(0), last);
        float present = gbuffer_depth(texel) > 0.0 ? 1.0 : 0.0;
        vec3 albedo = albedo_fetch(albedos, ivec3(texel, 0));
        smooth_seen shown = smooth_at(texel);
        vec3 direct = shown.rough * texelFetch(directs, texel, 0).rgb;
        vec3 indirect = shown.rough * params.indirect * irradiance_at(texel, is_edge_sample, pixel);
        vec3 weight = (albedo + LEAST_WEIGHT) * present;
        weights += weight;
        sum.coverage += present;
        sum.opacity += max(present, pane_opacity(texel));
        sum.albedo += albedo;
        sum.direct += weight * direct;
        sum.indirect += weight * indirect;
        sum.caustic += weight * shown.caustic;
        sum.direct_specular += (direct_specular(texel) + shown.direct) * present;
        sum.indirect_specular += (indirect_specular(texel) + shown.indirect) * present;
        sum.radiance += radiance_of(albedo, direct + shown.caustic + indirect, shown, texel);
        sum.airlight += airlight(texel);
        sum.volume += volume_caustic(texel);
    }
    float share = 1.0 / float(count);
    vec3 weighted = 1.0 / max(weights, vec3(LEAST_WEIGHT));
    return seen(sum.coverage * share, sum.opacity * share, sum.albedo * share, sum.direct * weighted,
                sum.indirect * weighted, sum.radiance * share, sum.direct_specular * share,
                sum.indirect_specular * share, sum.airlight * share, sum.caustic * weighted, sum.volume * share);
}

// What the pixel's middle sends, not yet through the medium; A: the part that is indirect light.
vec4 sent_by(ivec2 texel) {
    vec3 albedo = albedo_fetch(albedos, ivec3(texel, 0));
    vec3 direct = albedo * (texelFetch(directs, texel, 0).rgb + smooth_at(texel).caustic);
    vec3 indirect = albedo * params.indirect * irradiance_at(texel, false, texel) + indirect_specular(texel);
    vec3 all = direct + direct_specular(texel) + emitted(texel) + indirect;
    return vec4(all, dot(indirect, vec3(1.0)) / max(dot(all, vec3(1.0)), 1e-30));
}

seen seen_from(ivec2 pixel) {
    return seen_by(assignment_at(pixel), pixel);
}
