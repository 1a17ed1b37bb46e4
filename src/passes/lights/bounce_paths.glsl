// What paths have left, to be read by number: x of row y; of row 0, which leaves VPLs, by x alone. VPLs share it out.
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

// The area that VPL i stands for, of those around it that face alike: of random points P / A to an area the nearest of a
// share s lies within pi d^2 = A / (s P) on the mean.
layout(binding = UNIT_PATH_AREAS) uniform sampler2D path_areas; // a row's sum of such d^2

float path_area(int i) {
    const float PI = 3.14159265359;
    float sum = 0.0;
    for (int row = 0; row < BOUNCE_ROWS; row++)
        sum += texelFetch(path_areas, ivec2(i, row), 0).r;
    float share = float(min(params.later, BOUNCE_PARTNERS)) / float(params.later * BOUNCE_RUNS);
    return PI * share * sum / float(BOUNCE_RUNS);
}

// How light that paths leave is shared out to the VPLs around it, of a pool of them: by nearness and like normals, as values
// between scattered points are found [Shepard 1968].

// First and past the last of VPL i's.
ivec2 pool_of(int i) {
    int first = i / BOUNCE_POOL * BOUNCE_POOL;
    return ivec2(first, min(first + BOUNCE_POOL, params.later));
}

// The share that is lost: as that of a VPL so far away that it is too far, over the scene's radius.
const float LOST = 1.0;
const float TOO_FAR = 0.25;
const float OFF_PLANE = 30.0;

// Of light that one leaves to the other, before all and what is lost are made one. What lies off the plane of both is
// farther: a table's top gives the floor below nothing. A chord of what is bent evenly lies in it.
float share_between(path_end a, path_end b) {
    const float AT_LEAST = 2.5e-4; // of what is too far, squared
    vec3 apart = a.position - b.position;
    float like = max(dot(a.normal, b.normal), 0.0), far = TOO_FAR * params.radius;
    float off = OFF_PLANE * dot(apart, a.normal + b.normal);
    float distance2 = (dot(apart, apart) + off * off) / (far * far) + AT_LEAST;
    return like * like / (distance2 * distance2 * distance2);
}
