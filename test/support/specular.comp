// For test_specular.c: reflection towards the eye of a direction of light, directions that its lobe samples, and whole
// lights.
#include "lib/light.glsl"
#include "lib/unshadowed_specular.glsl"

layout(local_size_x = 1) in;

struct question {
    vec4 f0_and_alpha, normal, to_eye; // normal.w: a direction is to be sampled
    vec4 to_light; // or the sample's place; or the place, and the light's number
};
layout(std430, binding = 0) readonly buffer question_storage {
    question questions[];
};
layout(std430, binding = 1) buffer answer_storage {
    vec4 answers[];
};

void main() {
    uint i = gl_WorkGroupID.x;
    question q = questions[i];
    specular_surface s = specular_surface(q.f0_and_alpha.rgb, vec3(1.0), q.f0_and_alpha.a, q.normal.xyz,
                                          facing(q.normal.xyz, q.to_eye.xyz));
#if OF_LIGHTS
    light l = light_at(int(q.to_light.w));
    vec3 to_light = l.position - q.to_light.xyz;
    float distance2 = dot(to_light, to_light);
    vec3 direction = l.type == LIGHT_TYPE_DIRECTIONAL ? l.direction : -to_light * inversesqrt(distance2);
    answers[i].rgb = l.radiance * unshadowed_specular(l, s, q.to_light.xyz, direction, distance2);
#else
    vec3 to_light = q.normal.w > 0.0 ? lobe_sample(s, q.to_light.xy) : q.to_light.xyz;
    answers[i] = vec4(q.normal.w > 0.0 ? to_light : specular_brdf(s, to_light), lobe_density(s, to_light));
#endif
}
