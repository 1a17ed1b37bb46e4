// Where the samples of a pixel take their shading from. An edge sample is a point that the pixel sees beside its centre, of a
// surface that no pixel near has: one texel of 128 bits, written only where a pixel has one.
#include "lib/direction.glsl"

struct edge_sample {
    float depth; // as the G-buffer's
    vec3 normal;
    vec2 place;  // pixels from the pixel's centre
    uint assigned; // whose direct light and albedo it takes
};

uvec4 edge_sample_pack(edge_sample p) {
    uint normal = packUnorm2x16(octahedral_encode(p.normal));
    return uvec4(floatBitsToUint(p.depth), normal, packSnorm2x16(p.place), p.assigned);
}

edge_sample edge_sample_unpack(uvec4 code) {
    vec3 normal = octahedral_decode(unpackUnorm2x16(code.y));
    return edge_sample(uintBitsToFloat(code.x), normal, unpackSnorm2x16(code.z), code.w);
}

// Which of the 3 x 3 pixels around it a pixel's samples take their shading from: four bits a sample.
// 0 is the pixel itself, 1 .. 8 its neighbours, ASSIGNED_EDGE_SAMPLE its edge sample, ASSIGNED_NOTHING where the
// sample sees no surface.
const uint ASSIGNED_EDGE_SAMPLE = 9u;
const uint ASSIGNED_NOTHING = 15u;

// Row by row, the pixel itself taken out of its place and put first.
ivec2 assigned_offset(uint assigned) {
    int at = assigned == 0u ? 4 : int(assigned) - (assigned <= 4u ? 1 : 0);
    return ivec2(at % 3, at / 3) - 1;
}

uint assigned_to(uvec2 assignment, int index) {
    return assignment[index / 8] >> uint(4 * (index % 8)) & 15u;
}

// Whether any of the samples does: one of the fours of bits is zero without ASSIGNED_EDGE_SAMPLE, and borrows.
bool has_edge_sample(uvec2 assignment) {
    uvec2 others = assignment ^ 0x11111111u * ASSIGNED_EDGE_SAMPLE;
    return ((others - 0x11111111u) & ~others & 0x88888888u) != uvec2(0u);
}
