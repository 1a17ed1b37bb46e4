// For test_cluster_lights.c: what rectangle i, of unit flux, gives to the point in the origin that looks along n.
#define CLAMP GATHER_CLAMP_RECTANGLE
#include "lib/vpl_rows.glsl"
#include "passes/gather/rectangle.glsl"

layout(local_size_x = 64) in;

layout(std140, binding = BLOCK_VPLS) uniform vpl_uniforms {
    vec4 vpl_rows[VPLS_PER_BLOCK * VPL_ROWS];
};

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
    int row = i * VPL_ROWS;
    vpl light = vpl_of_rows(vpl_rows[row], vpl_rows[row + 1], vpl_rows[row + 2], vpl_rows[row + 3]);
    answers[i] = light_term(i, light.position, normals[i].xyz, light);
}
