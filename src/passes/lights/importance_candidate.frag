// Candidate i: a place of a light's domain, and the irradiance that a VPL there, or its light of later
// bounces, gives to the picture. This is its flux times
// the sum of geometry terms with pixels spread evenly over the picture, other pixels for each candidate. One ray tests
// visibility for all of them: to a pixel picked in proportion to its term, so that the estimate is unbiased.
#define CLAMP GATHER_CLAMP_DISK
#include "lib/vpl_shares.glsl"
#include "lib/random.glsl"
#include "passes/gather/geometry_term.glsl"
#include "lib/gbuffer.glsl"
#include "passes/lights/vpl_reflected.glsl"
#include "passes/visibility/bvh.glsl"
#include "shared/importance_map.h"
#ifdef BY_IMPORTANCE
#include "passes/lights/vpl_by_importance.glsl"
#else
#ifdef SKY_RAYS
#include "passes/lights/sky_pieces.glsl"
#endif

// In the first round as many of each light.
float vpl_choose(vec3 point, out int index, out vec2 place) {
    float turn = point.z * float(light_count);
    index = min(int(turn), light_count - 1);
    place = point.xy;
#ifdef SKY_RAYS
    vec4 door = sky_door(index);
    place = fract(turn) < 0.5 ? door.xy + door.zw * place : place;
#endif
    return 1.0;
}
#endif
#ifdef LATER
// A candidate counts for later bounces, too: as a VPL where its light walks to.
#include "passes/lights/light_walk.glsl"

uvec2 walk_chance = uvec2(0);

vec2 walk_number(int ray) {
    return random_of(uvec3(~ray, walk_chance));
}

float walk_weight(vec3 position, vec3 normal) {
    return 1.0;
}

vpl walked(vpl v, int i) {
    walk_chance = uvec2(i, ROUND);
    walk w = walk(v.position + params.start * v.normal, v.normal, v.flux, dot(v.flux, vec3(1.0)) > 0.0);
    walk_end end = WALK_BEGIN;
    float pick = random_of(uvec3(0, walk_chance)).x;
    walk_on(w, params.bounces, false, walk_chance, pick, end);
    return vpl_even(end.position, end.normal, params.area, walk_flux(end), 0.0);
}
#endif

layout(location = TARGET_RESULT) out vec4 candidate; // place, light, value

// Multiples of the powers of 1/x, x^5 = x + 1, in 32 bits: evenly spread in four dimensions.
vec4 numbers_of(int i) {
    const uvec4 STEPS = uvec4(3679391137u, 3152041523u, 2700274806u, 2313257605u);
    return vec4(uint(i) * STEPS >> 8) / 16777216.0;
}

float arriving(vpl v, vec2 shift, float pick) {
    float sum = 0.0;
    vec3 position = vec3(0.0), normal = vec3(0.0);
    for (int j = 0; j < CANDIDATE_PIXELS; j++) {
        surface s = seen_pixel(j, shift);
        float term = s.present ? light_term(0, v.position - s.position, s.normal, v) : 0.0;
        sum += term;
        bool taken = weighted_pick(term, sum, pick);
        position = taken ? s.position : position;
        normal = taken ? s.normal : normal;
    }
    vec3 end = sum > 0.0 ? v.position : position; // no way, no ray
    return is_blocked(position, normal, end) ? 0.0 : sum;
}

float value_of(vpl v, vec2 shift, float pick) {
    float power = dot(v.flux, vec3(1.0));
    return power > 0.0 ? power * arriving(v, shift, pick) : 0.0;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int i = texel.y * params.side + texel.x, index;
    vec4 number = numbers_of(i + 1);
    vec2 place;
    vpl_choose(number.xyz, index, place);
    vpl v = vpl_reflected(index, i, vpl_share_at(index).measure, place);
    vec2 shift = fract(number.xy * 31.0 + number.wz);
    candidate = vec4(place, float(index), value_of(v, shift, number.w));
#ifdef LATER
    candidate.w += value_of(walked(v, i), shift, number.w);
#endif
}
