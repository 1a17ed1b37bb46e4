// A pixel's lights are a range of all VPLs: `slot` has its first and its count.
#include "lib/vpl_texels.glsl"

// The first, and the one after the last.
ivec2 lights_of(ivec2 pixel) {
    return ivec2(slot.x, slot.x + slot.y);
}

vpl light_at(int i) {
    return vpl_at(i);
}
