// Puts the interleaved tiles back into picture order, and each pixel's depth, normal and light together.
#include "gather/blur_tap.glsl"
#include "gather/list_texel.glsl"
#include "lib/gbuffer.glsl"
#include "lib/interleaving.glsl"
#include "shared/blur.h"

layout(binding = UNIT_IRRADIANCE) uniform sampler2D source;
#if DETAIL
layout(binding = UNIT_LIST_TEXELS) uniform usampler2D list_texels;
layout(binding = UNIT_DETAIL_IRRADIANCE) uniform sampler2D detail_irradiance;
#endif

#if GLOSS
#include "lib/gbuffer_shine.glsl"
#endif

layout(location = TARGET_RESULT) out uvec4 packed_tap;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg);
    float depth = gbuffer_depth(pixel);
    vec3 irradiance = texelFetch(source, interleaved_texel(params.pattern, pixel), 0).rgb;
    int grade = 0;
#if DETAIL
    uint code = texelFetch(list_texels, pixel, 0).r;
    if (list_texel_has(code)) {
        grade = 1 + list_grade_of(code);
        irradiance = texelFetch(detail_irradiance, list_texel_of(code), 0).rgb;
    }
#endif
#if GLOSS
    float roughness = gloss_decode(texelFetch(gbuffer_glosses, ivec3(pixel, 0), 0)).a;
    grade = is_smooth(roughness * roughness) ? 1 : 0;
#endif
    packed_tap = blur_tap_pack(blur_tap(depth > 0.0 ? view_linear_depth(camera, depth) : 0.0,
                                        blur_tap_normal_code(normal), irradiance, grade));
}
