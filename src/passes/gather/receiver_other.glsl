// All pixels but those that lists have.
#include "passes/gather/list_texel.glsl"
#include "passes/gather/receiver_facet.glsl"
#include "lib/gbuffer.glsl"
#include "lib/interleaving.glsl"

layout(binding = UNIT_LIST_TEXELS) uniform usampler2D list_texels;

bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    pixel = interleaved_pixel(pattern, ivec2(gl_FragCoord.xy), place);
    return !list_texel_has(texelFetch(list_texels, pixel, 0).r);
}

surface receiver_surface(ivec2 pixel) {
    return gbuffer_surface(pixel);
}

vec3 receiver_triangle(surface s, ivec2 pixel) {
    return facet_of_code(texelFetch(list_texels, pixel, 0).r);
}
