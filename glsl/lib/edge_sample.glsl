// A point that a pixel sees beside its centre, of a surface that no pixel near has: what one texel of 128 bits says.
// Only texels of pixels that have one are ever written (passes/picture/sample_assignment.glsl).
#include "lib/octahedral.glsl"

struct edge_sample {
    float depth; // as the G-buffer's
    vec3 normal;
    vec2 place;  // pixels from the pixel's centre
    uint assigned; // passes/picture/sample_assignment.glsl: whose direct light and albedo it takes
};

uvec4 edge_sample_pack(edge_sample p) {
    uint normal = packUnorm2x16(octahedral_encode(p.normal));
    return uvec4(floatBitsToUint(p.depth), normal, packSnorm2x16(p.place), p.assigned);
}

edge_sample edge_sample_unpack(uvec4 code) {
    vec3 normal = octahedral_decode(unpackUnorm2x16(code.y));
    return edge_sample(uintBitsToFloat(code.x), normal, unpackSnorm2x16(code.z), code.w);
}
