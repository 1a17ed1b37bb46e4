// The irradiance of a technique that has it.
#include "gather/list_texel.glsl"

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
