// A candidate counts for later bounces, too: as a VPL where its light walks to.
#include "lights/light_walk.glsl"

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
