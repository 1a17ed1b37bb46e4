// A step of a bitonic sort [Batcher 1968]: each invocation puts one pair in order.
#include "passes/lights/tree_keys.glsl"

layout(local_size_x = TREE_GROUP) in;

// Keys in a sequence that the stage sorts; how far the pair is apart.
layout(location = LOCATION_TREE_STEP) uniform ivec4 tree_step;

bool is_after(uvec4 a, uvec4 b) {
    if (a.x != b.x)
        return a.x > b.x;
    return a.y != b.y ? a.y > b.y : a.z > b.z;
}

void main() {
    int pair = int(gl_GlobalInvocationID.x), apart = tree_step.y;
    if (pair >= params.leaves / 2)
        return;
    int i = pair / apart * apart * 2 + pair % apart, j = i + apart;
    uvec4 a = tree_keys[i], b = tree_keys[j];
    bool rising = (i & tree_step.x) == 0;
    if (is_after(a, b) == rising) {
        tree_keys[i] = b;
        tree_keys[j] = a;
    }
}
