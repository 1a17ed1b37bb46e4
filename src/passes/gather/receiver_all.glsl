// All pixels: a texel's is the one at the tile's place in the pattern.
#include "lib/gbuffer.glsl"
#include "lib/interleaving.glsl"
#include "passes/gather/receiver_facet.glsl"

bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    pixel = interleaved_pixel(pattern, ivec2(gl_FragCoord.xy), place);
    return true;
}

surface receiver_surface(ivec2 pixel) {
    return gbuffer_surface(pixel);
}

vec3 receiver_triangle(surface s, ivec2 pixel) {
    return facet_of(s, pixel);
}
