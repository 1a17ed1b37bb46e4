// For test_cluster_lights.c: what rectangle i, of unit flux, gives to the point in the origin that looks along n.
#define CLAMP GATHER_CLAMP_RECTANGLE
#include "lib/vpl_block.glsl"
#include "passes/gather/rectangle.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer normal_storage {
    vec4 normals[];
};
layout(std430, binding = 1) writeonly buffer answer_storage {
    float answers[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= normals.length())
        return;
    vpl light = vpl_in_block(i);
    answers[i] = light_term(i, light.position, normals[i].xyz, light);
}
