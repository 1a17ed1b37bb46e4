// For test_area_lights.c: what light i gives to point i.
#include "lib/unshadowed.glsl"

layout(local_size_x = 64) in;

struct point {
    vec4 position, normal;
};
layout(std430, binding = 0) readonly buffer point_storage {
    point points[];
};
layout(std430, binding = 1) writeonly buffer answer_storage {
    float answers[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(points.length()))
        return;
    light l = light_at(int(i));
    vec3 path = points[i].position.xyz - l.position;
    vec3 direction = l.type == LIGHT_TYPE_DIRECTIONAL ? l.direction : normalize(path);
    answers[i] = unshadowed(l, points[i].position.xyz, points[i].normal.xyz, direction, dot(path, path));
}
