// Puts the interleaved tiles back into picture order, and each pixel's depth, normal and light together.
#include "lib/gbuffer.glsl"
#include "lib/tiles.glsl"
#include "passes/gather/blur_tap.glsl"
#include "shared/gather.h"

PASS_BLOCK(blur_params, 96)

layout(binding = UNIT_IRRADIANCE) uniform sampler2D source;
#if ADAPTIVE
layout(binding = UNIT_LIST_TEXELS) uniform usampler2D list_texels;
layout(binding = UNIT_ADAPTIVE_IRRADIANCE) uniform sampler2D adaptive_irradiance;

// Where so much light arrives it comes from an area no larger than all power over the irradiance, and changes over a
// part of its width: where that is so few pixels, the window of an edge takes too much from beside it.
const float STEEP_WITHIN = 100.0;

bool is_steep(vec3 irradiance, float depth) {
    float pixel = view_height(camera, depth) / float(gbuffer_size().y) * STEEP_WITHIN;
    return dot(irradiance, vec3(1.0 / 3.0)) * pixel * pixel * params.inverse_power > 1.0;
}
#endif

#if SPECULAR_BLUR
const float NARROW_ROUGHNESS = 0.45; // lobes that bent surfaces soon turn away
#endif

layout(location = TARGET_RESULT) out uvec4 packed_tap;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg);
    float depth = gbuffer_depth(pixel);
    vec3 irradiance = texelFetch(source, interleaved_texel(params.pattern, pixel), 0).rgb;
    int level = BLUR_LEVEL_NONE;
#if ADAPTIVE
    uint code = texelFetch(list_texels, pixel, 0).r;
    if (list_texel_has(code)) {
        irradiance = texelFetch(adaptive_irradiance, list_texel_of(code), 0).rgb;
        level = BLUR_LEVEL_OF_LIST(list_level_of(code));
        if (list_level_of(code) == PIXEL_LEVEL_EDGE && is_steep(irradiance, depth))
            level = BLUR_LEVEL_STEEP;
    }
#endif
#if SPECULAR_BLUR
    irradiance /= pixel_reflects(pixel);
    float roughness = specular_decode(texelFetch(gbuffer_speculars, ivec3(pixel, 0), 0)).a;
    level = roughness < NARROW_ROUGHNESS ? BLUR_LEVEL_OF_LIST(PIXEL_LEVEL_DETAIL) : BLUR_LEVEL_NONE;
    level = is_smooth(roughness * roughness) ? BLUR_LEVEL_OF_LIST(PIXEL_LEVEL_EDGE) : level;
#endif
    packed_tap = blur_tap_pack(blur_tap(depth > 0.0 ? view_linear_depth(camera, depth) : 0.0,
                                        blur_tap_normal_code(normal), irradiance, level));
}
