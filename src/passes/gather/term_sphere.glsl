// The term of a ball around a VPL, by gather_params.
#include "passes/gather/sphere.glsl"

const bool TERM_OF_POINT = false; // balls may rise above a horizon in part

float light_term(int i, vec3 to_light, vec3 normal, vpl light) {
    return sphere_term(to_light, normal, light.normal, params.sphere2 * light.area);
}
