// For test_imperfect_volume.c: irradiance by spherical harmonics of a light that comes from a cap, or from all around with a
// slope: radiance 1 + v.w within the cap of that cosine about its axis, else 0.
#include "lib/sh.glsl"

layout(local_size_x = 1) in;

struct question {
    vec4 axis;   // of the cap, and the least cosine
    vec4 slope;  // v
    vec4 normal; // of the surface
};
layout(std430, binding = 0) readonly buffer question_storage {
    question questions[];
};
layout(std430, binding = 1) buffer answer_storage {
    vec4 answers[]; // of order 2, of order 3
};

void main() {
    const int RAYS = 65536;
    question q = questions[gl_WorkGroupID.x];
    vec4 low = vec4(0.0), high = vec4(0.0);
    float last = 0.0;
    for (int i = 0; i < RAYS; i++) {
        float z = 1.0 - (2.0 * float(i) + 1.0) / float(RAYS), r = sqrt(1.0 - z * z);
        float turn = 6.2831853 * float((uint(i) * 2654435769u) >> 8u) / 16777216.0;
        vec3 direction = vec3(r * cos(turn), r * sin(turn), z);
        float light = dot(direction, q.axis.xyz) >= q.axis.w ? 1.0 + dot(direction, q.slope.xyz) : 0.0;
        low += light * sh_low(direction);
        high += light * sh_high(direction);
        last += light * sh_last(direction);
    }
    float each = 12.5663706 / float(RAYS), order2 = dot(low, sh_cosine_low(q.normal.xyz)) * each;
    float more = (dot(high, sh_cosine_high(q.normal.xyz)) + last * sh_cosine_last(q.normal.xyz)) * each;
    answers[gl_WorkGroupID.x] = vec4(order2, order2 + more, 0.0, 0.0);
}
