// VPLs of sampled lights: a light by its flux, a direction evenly over what it shines into, and what a ray meets there.
#include "lib/lattice.glsl"
#include "lib/light_domain.glsl"
#include "lib/light_tree.glsl"
#include "lib/medium.glsl"
#include "lib/random.glsl"
#include "lib/vpl_rows.glsl"
#include "passes/visibility/bvh.glsl"
#include "passes/lights/triangle_albedo.glsl"

const int AREA_SAMPLES = 2;

// Irradiance of all sampled lights at a point that nothing hides, over their flux, 1/m2.
float irradiance_over_flux(vec3 position, vec3 normal, uint number) {
    float sum = 0.0, probability;
    for (int k = 0; k < AREA_SAMPLES; k++) {
        float shift = lattice_number(number * LATTICE_GOLDEN);
        float number = (float(k) + shift) / float(AREA_SAMPLES);
        int i = light_tree_sample(position, normal, number, probability);
        light l = sampled_light_piece(max(i, 0), vec2(0.5));
        vec3 direction;
        float distance2;
        float power = dot(light_towards(l, position, direction, distance2), vec3(1.0 / 3.0));
        sum += i >= 0 ? power * max(-dot(normal, direction), VPL_COSINE_MIN) / (distance2 * probability) : 0.0;
    }
    return sum / float(AREA_SAMPLES);
}

// The area that a VPL there stands for, by flux alone.
float sampled_vpl_area(light many, float measure, vec3 position, vec3 normal, uint number) {
    return measure * many.extent / max(irradiance_over_flux(position, normal, number), 1e-30);
}

// Where a place that a light shines to lies in the domain of all.
vec2 sampled_light_place(int i, light l, vec3 position) {
    vec2 own = light_domain_place(l, position);
    return vec2(sampled_light_row(i, 0).w + own.y * sampled_light_flux(i), own.x);
}

// `measure`: the fraction of all VPLs' flux that it stands for; x of the place chooses the light.
vpl vpl_by_sampled_light(light many, int number, float measure, vec2 place) {
    float rest = place.x;
    int i = light_by_flux(rest);
    light l = sampled_light_piece(i, random_of(uvec3(floatBitsToUint(place), number)));
    vec3 direction = light_domain_direction(l, vec2(place.y, rest));
    float clearance = bvh_clearance(), domain = 2.0 * LIGHT_DOMAIN_PI * (1.0 - light_domain_end(l));
    vec3 from = l.position + (l.type == LIGHT_TYPE_AREA ? clearance * l.direction : vec3(0.0));
    bvh_hit hit = bvh_meet(from, direction, true);
    surface s = surface(hit.triangle >= 0, from + hit.distance * direction, hit.normal);
    vec3 albedo = reflected(hit);
    vec3 arrives = medium_sends(from, direction, true, floatBitsToUint(place) + uint(number), s, albedo);
    if (!s.present)
        return vpl_even(from, -direction, 0.0, vec3(0.0), 0.0);
    float distance2 = hit.distance * hit.distance;
    vec3 power = light_intensity(l, direction) * light_in_range(l, distance2) * arrives;
    float area = sampled_vpl_area(many, measure, s.position, s.normal, uint(number));
    return vpl_even(s.position, s.normal, area, albedo * power * (domain * measure / sampled_light_flux(i)), 0.0);
}
