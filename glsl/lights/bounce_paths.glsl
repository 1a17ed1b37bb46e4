// What paths have left, to be read by number.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_POSITIONS) uniform sampler2D path_positions;
layout(binding = UNIT_PATH_NORMALS) uniform sampler2D path_normals;
layout(binding = UNIT_PATH_FLUXES) uniform sampler2D path_fluxes;
layout(binding = UNIT_PATH_NEXT) uniform sampler2D path_nexts;

vec3 path_position(int i) {
    return texelFetch(path_positions, ivec2(i, 0), 0).xyz;
}

// Where its light goes from there; A: how far that is, -1: nowhere.
vec4 path_next(int i) {
    return texelFetch(path_nexts, ivec2(i, 0), 0);
}

vec3 path_normal(int i) {
    return texelFetch(path_normals, ivec2(i, 0), 0).xyz;
}

vec3 path_flux(int i) {
    return texelFetch(path_fluxes, ivec2(i, 0), 0).rgb;
}

float path_power(int i) {
    return dot(path_flux(i), vec3(1.0));
}
