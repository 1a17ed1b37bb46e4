// The layers of a picture, from the buffers of the frame.
#include "lib/gbuffer.glsl"
#include "picture/layer_weight.glsl"
#include "picture/picks.glsl"
#include "shared/composite.h"

layout(binding = UNIT_GBUFFER_ALBEDO) uniform sampler2DArray albedos;
layout(binding = UNIT_DIRECT) uniform sampler2D directs;
#ifdef HAS_IRRADIANCE
layout(binding = UNIT_IRRADIANCE) uniform sampler2D irradiances;
#endif
layout(binding = UNIT_SAMPLE_PICKS) uniform usampler2D sample_picks;
#ifdef HAS_GLOSS
layout(binding = UNIT_DIRECT_SPECULAR) uniform sampler2D direct_speculars;
#endif
layout(binding = UNIT_FURTHER_POINTS) uniform usampler2D further_points;
#ifdef HAS_FURTHER_POINTS
#include "gather/list_texel.glsl"
layout(binding = UNIT_FURTHER_TEXELS) uniform usampler2D further_texels;
layout(binding = UNIT_FURTHER_IRRADIANCE) uniform sampler2D further_irradiance;
#endif
#ifdef HAS_RADIANCE
layout(binding = UNIT_RADIANCE) uniform sampler2D radiances;
#endif
#ifdef HAS_MEDIUM
layout(binding = UNIT_IN_SCATTER) uniform sampler2D in_scatters;
layout(binding = UNIT_TRANSMITTANCE) uniform sampler2D transmittances;
#endif

#ifdef HAS_SKY
#include "picture/sky.glsl"
#endif

// What lies behind all surfaces.
vec3 background(ivec2 pixel) {
#ifdef HAS_SKY
    return params.sky_strength > 0.0 ? sky_radiance(pixel) : vec3(0.0);
#else
    return vec3(0.0);
#endif
}

// What the pixel sees, the mean over its samples. Light is irradiance over pi, the radiance of a
// white surface; weighted by the albedo, so that albedo (direct + indirect) = radiance at edges too.
// Specular is radiance.
struct seen {
    float coverage;
    vec3 albedo, direct, indirect, radiance, direct_specular, indirect_specular;
};

#ifdef HAS_EMISSION
layout(binding = UNIT_GBUFFER_EMISSION) uniform sampler2DArray emissions;
#endif

// What the technique adds on its way from surface to camera, if anything.
vec3 through_medium(vec3 radiance, ivec2 texel) {
#ifdef HAS_MEDIUM
    return radiance * texelFetch(transmittances, texel, 0).rgb +
           params.scale * texelFetch(in_scatters, texel, 0).rgb;
#else
    return radiance;
#endif
}

vec3 direct_specular(ivec2 texel) {
#ifdef HAS_GLOSS
    return texelFetch(direct_speculars, texel, 0).rgb;
#else
    return vec3(0.0);
#endif
}

// Not of light that comes straight from a source.
vec3 indirect_specular(ivec2 texel) {
#ifdef HAS_RADIANCE
    return params.scale * texelFetch(radiances, texel, 0).rgb;
#else
    return vec3(0.0);
#endif
}

vec3 radiance_of(vec3 albedo, vec3 received, ivec2 texel) {
    if (gbuffer_depth(texel) == 0.0)
        return through_medium(background(texel), texel);
    vec3 radiance = albedo * received;
#ifdef HAS_GLOSS
    radiance += direct_specular(texel);
#endif
#ifdef HAS_EMISSION
    radiance += params.scale * texelFetch(emissions, ivec3(texel, 0), 0).rgb;
#endif
#ifdef HAS_RADIANCE
    radiance += indirect_specular(texel);
#endif
    return through_medium(radiance, texel);
}

// At a sample's pixel, or at the further point of the pixel that has the sample.
vec3 irradiance_at(ivec2 texel, bool is_further, ivec2 pixel) {
    vec3 irradiance = vec3(0.0);
#ifdef HAS_IRRADIANCE
    irradiance = texelFetch(irradiances, texel, 0).rgb;
#endif
#ifdef HAS_FURTHER_POINTS
    if (is_further) {
        ivec2 listed = list_texel_of(texelFetch(further_texels, pixel, 0).r);
        irradiance = texelFetch(further_irradiance, listed, 0).rgb;
    }
#endif
    return irradiance;
}

uvec2 picks_at(ivec2 pixel) {
    return texelFetch(sample_picks, min(pixel, textureSize(sample_picks, 0) - 1), 0).rg;
}

seen seen_by(uvec2 picks, ivec2 pixel) {
    ivec2 last = gbuffer_size() - 1;
    int count = picks == uvec2(0u) ? 1 : params.samples;
    seen sum = seen(0.0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 weights = vec3(0.0);
    uint stand_in = 0u;
    if (picks_further_point(picks))
        stand_in = texelFetch(further_points, pixel, 0).w;
    for (int i = 0; i < count; i++) {
        uint pick = pick_of(picks, i);
        if (pick == PICK_NOTHING) {
            sum.radiance += through_medium(background(pixel), pixel);
            continue;
        }
        bool is_further = pick == PICK_FURTHER;
        ivec2 texel = clamp(pixel + pick_offset(is_further ? stand_in : pick), ivec2(0), last);
        float present = gbuffer_depth(texel) > 0.0 ? 1.0 : 0.0;
        vec3 albedo = albedo_fetch(albedos, ivec3(texel, 0));
        vec3 direct = texelFetch(directs, texel, 0).rgb;
        vec3 indirect = params.indirect * irradiance_at(texel, is_further, pixel);
        vec3 weight = (albedo + LEAST_WEIGHT) * present;
        weights += weight;
        sum.coverage += present;
        sum.albedo += albedo;
        sum.direct += weight * direct;
        sum.indirect += weight * indirect;
#ifdef HAS_GLOSS
        sum.direct_specular += direct_specular(texel) * present;
        sum.indirect_specular += indirect_specular(texel) * present;
#endif
        sum.radiance += radiance_of(albedo, direct + indirect, texel);
    }
    float share = 1.0 / float(count);
    vec3 weighted = 1.0 / max(weights, vec3(LEAST_WEIGHT));
    return seen(sum.coverage * share, sum.albedo * share, sum.direct * weighted,
                sum.indirect * weighted, sum.radiance * share, sum.direct_specular * share,
                sum.indirect_specular * share);
}

seen seen_from(ivec2 pixel) {
    return seen_by(picks_at(pixel), pixel);
}
