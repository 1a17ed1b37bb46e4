// For test_traced.c: which of the points a ray reaches.
#include "passes/visibility/bvh.glsl"

layout(local_size_x = 64) in;

struct pair {
    vec4 from, normal, to;
};
layout(std430, binding = 0) readonly buffer pair_storage {
    pair pairs[];
};
layout(std430, binding = 1) writeonly buffer answer_storage {
    uint answers[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(pairs.length()))
        answers[i] = is_blocked(pairs[i].from.xyz, pairs[i].normal.xyz, pairs[i].to.xyz) ? 1u : 0u;
}
