// For test_vpl_tree.c: the bound of a node's geometry term for a receiver.
#include "passes/gather/cut_bound.glsl"

layout(local_size_x = 1) in;

struct question {
    vec4 receiver[3]; // low, high, axis and cosine
    vec4 node[3];     // the same
    vec4 area_and_clamp;
};
layout(std430, binding = 0) readonly buffer question_storage {
    question questions[];
};
layout(std430, binding = 1) buffer answer_storage {
    float answers[];
};

void main() {
    uint i = gl_WorkGroupID.x;
    question q = questions[i];
    tree_extent receiver = tree_extent(q.receiver[0].xyz, q.receiver[1].xyz, q.receiver[2].xyz, q.receiver[2].w);
    tree_extent extent = tree_extent(q.node[0].xyz, q.node[1].xyz, q.node[2].xyz, q.node[2].w);
    tree_node node = tree_node(extent, 0.0, q.area_and_clamp.x, vec3(1.0), 3.0);
    answers[i] = cut_bound(receiver, node, q.area_and_clamp.y);
}
