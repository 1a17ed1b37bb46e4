#include "lib/divide.glsl"
#include "shared/gather.h"

// The pixel of the picture that a texel of a tile stands for; the tile by its place in the pattern.
ivec2 interleaved_pixel(interleaving pattern, ivec2 texel, ivec2 place) {
    return (texel - place * pattern.tile) * pattern.n + place;
}

// And back.
ivec2 interleaved_texel(interleaving pattern, ivec2 pixel) {
    ivec2 texel = divide(pixel, ivec2(pattern.n)), place = pixel - texel * pattern.n;
    return place * pattern.tile + texel;
}
