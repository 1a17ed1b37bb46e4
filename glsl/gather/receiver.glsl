// The pixel that a texel of a tile gathers for: of all pixels the one at its place in the pattern, but not those
// that lists have, or the one that a list has there.
#include "lib/interleaving.glsl"

#if RECEIVERS == RECEIVERS_LISTED
layout(binding = UNIT_LISTED_PIXELS) uniform usampler2D listed_pixels;

flat in ivec2 listed; // where this tile has the list, row by row: begin, end

// False outside the list.
bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    ivec2 texel = ivec2(gl_FragCoord.xy), within = texel - place * pattern.tile;
    uint code = texelFetch(listed_pixels, texel, 0).r;
    pixel = ivec2(code & 0xffffu, code >> 16);
    int at = within.y * pattern.tile.x + within.x;
    return at >= listed.x && at < listed.y;
}
#else
#if RECEIVERS == RECEIVERS_OTHERS
layout(binding = UNIT_LIST_TEXELS) uniform usampler2D list_texels;
#endif

bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    pixel = interleaved_pixel(pattern, ivec2(gl_FragCoord.xy), place);
#if RECEIVERS == RECEIVERS_OTHERS
    return texelFetch(list_texels, pixel, 0).r == 0u;
#else
    return true;
#endif
}
#endif
