// What paths have left, to be read by number: x of row y; of row 0, which leaves VPLs, by x alone.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_POSITIONS) uniform sampler2D path_positions;
layout(binding = UNIT_PATH_NORMALS) uniform sampler2D path_normals;
layout(binding = UNIT_PATH_FLUXES) uniform sampler2D path_fluxes;
layout(binding = UNIT_PATH_NEXT) uniform sampler2D path_nexts;

// Where, in one texel, for loops over many.
struct path_end {
    vec3 position;
    vec3 normal; // within a hundredth
};

path_end path_end_at(ivec2 path) {
    vec4 texel = texelFetch(path_positions, path, 0);
    return path_end(texel.xyz, unpackSnorm4x8(floatBitsToUint(texel.w)).xyz);
}

vec3 path_position(int i) {
    return texelFetch(path_positions, ivec2(i, 0), 0).xyz;
}

vec3 path_normal(int i) {
    return texelFetch(path_normals, ivec2(i, 0), 0).xyz;
}

vec3 path_flux(ivec2 path) {
    return texelFetch(path_fluxes, path, 0).rgb;
}

// Where its light goes from there; A: how far that is, -1: nowhere.
vec4 path_next(int i) {
    return texelFetch(path_nexts, ivec2(i, 0), 0);
}

float path_power(int i) {
    return dot(path_flux(ivec2(i, 0)), vec3(1.0));
}
