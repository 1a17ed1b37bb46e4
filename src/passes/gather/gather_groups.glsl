// Of VPLs side by side two test the visibility of all: one for those of much the same hue. Where red light and green
// shared an answer, shadows would be of neither's hue.
#include "lib/vpl_sums.glsl"
#include "passes/gather/representative.glsl"
#include "passes/gather/visibility_pixel.glsl"

struct light_group {
    vec3 sum, own, place; // own: what its representative gives, less where it does not arrive
    float strength, map;
};

// A light that is the group's own, whose strength it brings to `strength`, and whether it represents all.
void group_add(inout light_group group, bool its_own, vec3 own, vec3 own_back, float strength, bool taken, vec3 place,
               float map) {
    group.sum += its_own ? own : vec3(0.0);
    group.strength = its_own ? strength : group.strength;
    taken = taken && its_own;
    group.own = taken ? own + own_back : group.own;
    group.place = taken ? place : group.place;
    group.map = taken ? map : group.map;
}

vec3 light_of_group(light_group group, surface s) {
    return group_light(group.sum, group.strength, group.own, visibility_of(int(group.map), s, group.place));
}

// Of the VPLs first .. last, of which some are redder than that hue, that of all.
vec3 light_together(surface s, int first, int last, vec2 hue, float random) {
    light_group none = light_group(vec3(0.0), vec3(0.0), s.position, 0.0, 0.0);
    light_group redder = none, greener = none;
    for (int i = first; i < last; i++) {
        vpl light = light_at(i);
        vec3 back, own = unshadowed(i, light, s, back);
        bool is_red = light.flux.r * hue.g > light.flux.g * hue.r;
        float own_strength = dot(own + back, vec3(1.0));
        float strength = own_strength + (is_red ? redder.strength : greener.strength);
        bool taken = weighted_pick(own_strength, strength, random);
        float map = float(map_of(i, light));
        group_add(redder, is_red, own, back, strength, taken, light.position, map);
        group_add(greener, !is_red, own, back, strength, taken, light.position, map);
    }
    return light_of_group(redder, s) + light_of_group(greener, s);
}

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    vec3 sum = vec3(0.0);
    vec2 hue = vpl_hue();
    float random = group_random(pixel, params.turn);
    int together = lights_per_test(params.together);
    for (int i = lights.x; i < lights.y; i += together) {
        sum += light_together(s, i, min(i + together, lights.y), hue, random);
        random = group_random_next(random);
    }
    return sum;
}
