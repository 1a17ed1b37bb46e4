// For test_specular.c: what balls of VPLs give, over what the VPL is: form factor times pi per area.
#include "passes/gather/vpl_terms.glsl"

layout(local_size_x = 1) in;

struct question {
    vec4 to_vpl;     // and the squared radius of the ball
    vec4 normal;     // of the receiver, and whether a whole plane of such VPLs shines
    vec4 vpl_normal;
    vec4 unused;
};
layout(std430, binding = 0) readonly buffer question_storage {
    question questions[];
};
layout(std430, binding = 1) buffer answer_storage {
    vec4 answers[];
};

// All VPLs of the plane, rings by the logarithm of their radius.
float plane_of(question q) {
    const int RINGS = 600, AROUND = 96;
    const float INNER = 1e-3, SPAN = log(1e7), TURN = 6.28318530718;
    float sum = 0.0;
    for (int i = 0; i < RINGS; i++) {
        float radius = INNER * exp(SPAN * (float(i) + 0.5) / float(RINGS));
        float area = TURN * radius * radius * SPAN / float(RINGS) / float(AROUND);
        for (int j = 0; j < AROUND; j++) {
            float turn = TURN * (float(j) + 0.5) / float(AROUND);
            vec3 to_vpl = q.to_vpl.xyz + radius * vec3(cos(turn), sin(turn), 0.0);
            sum += area * sphere_term(to_vpl, q.normal.xyz, q.vpl_normal.xyz, q.to_vpl.w);
        }
    }
    return sum;
}

void main() {
    question q = questions[gl_WorkGroupID.x];
    answers[gl_WorkGroupID.x] =
        vec4(q.normal.w > 0.0 ? plane_of(q)
                              : sphere_term(q.to_vpl.xyz, q.normal.xyz, q.vpl_normal.xyz, q.to_vpl.w));
}
