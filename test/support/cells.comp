// For test_prefilter.c: what a filter makes of one cell with given moments.
#include "passes/visibility/lookup.glsl"
#include "passes/visibility/projection_light_map.glsl"
#include "passes/visibility/filter_light_map.glsl"

layout(local_size_x = 1) in;

struct answer {
    vec4 moments; // in
    float plane;  // in
    float share, depth, unused;
};
layout(std430, binding = 0) buffer answer_storage {
    answer answers[];
};

void main() {
    uint i = gl_WorkGroupID.x;
    cells c = cells_none();
    cells_add(c, cell(1.0, answers[i].plane, answers[i].moments, ivec3(0)));
    blocked b = cells_blocked(c);
    answers[i].share = b.share;
    answers[i].depth = b.depth;
}
