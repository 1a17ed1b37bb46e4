// For test_lattice.c: numbers of pixels that are APART from each other.
#include "passes/gather/representative.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) writeonly buffer numbers {
    float number[];
};

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    number[at.y * SIDE + at.x] = group_random(at * APART, 0.0);
}
