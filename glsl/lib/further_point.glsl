// A point that a pixel sees beside its centre, of a surface that no pixel near has: what one texel of 128 bits says.
// Only texels of pixels that have one are ever written (picture/picks.glsl).
#include "lib/octahedral.glsl"

struct further_point {
    float depth; // as the G-buffer's
    vec3 normal;
    vec2 place;  // pixels from the pixel's centre
    uint pick;   // picture/picks.glsl: whose direct light and albedo it takes
};

uvec4 further_point_pack(further_point p) {
    uint normal = packUnorm2x16(octahedral_encode(p.normal));
    return uvec4(floatBitsToUint(p.depth), normal, packSnorm2x16(p.place), p.pick);
}

further_point further_point_unpack(uvec4 code) {
    vec3 normal = octahedral_decode(unpackUnorm2x16(code.y));
    return further_point(uintBitsToFloat(code.x), normal, unpackSnorm2x16(code.z), code.w);
}
