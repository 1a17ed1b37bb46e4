// For test_lookup.c: which map knows each point that VAL 0 is asked for.
#include "shared/maps.h"

layout(local_size_x = 1) in;

layout(std140, binding = BLOCK_LOOKUP) uniform lookup_uniforms {
    lookup_params lookup;
};

#include "passes/visibility/map_in_front.glsl"

layout(std430, binding = 0) readonly buffer point_storage {
    vec4 points[];
};
layout(std430, binding = 1) writeonly buffer answer_storage {
    int answers[];
};

void main() {
    answers[gl_GlobalInvocationID.x] = map_in_front(0, points[gl_GlobalInvocationID.x].xyz);
}
