// VPLs of sampled lights: a light by its flux, a direction evenly over what it shines into, and what a ray meets there.
#include "lib/light_domain.glsl"
#include "lib/light_tree.glsl"
#include "lib/random.glsl"
#include "lib/vpl_rows.glsl"
#include "passes/visibility/bvh.glsl"
#include "passes/lights/light_end.glsl"
#include "passes/lights/vpl_lobe.glsl"

const int AREA_SAMPLES = 4;

// Irradiance by one light at a point that nothing hides, W/m2.
float unhidden_irradiance(light l, vec3 position, vec3 normal) {
    vec3 direction;
    float distance2;
    float power = dot(light_towards(l, position, direction, distance2), vec3(1.0 / 3.0));
    return power * max(-dot(normal, direction), VPL_COSINE_MIN) / distance2;
}

// The same by all sampled lights, estimated. By the same numbers everywhere, so that VPLs and rays of the near field have one
// area for a place, and share its light without a rest.
float all_unhidden_irradiance(vec3 position, vec3 normal) {
    float sum = 0.0, probability;
    for (int k = 0; k < AREA_SAMPLES; k++) {
        float number = (float(k) + 0.5) / float(AREA_SAMPLES);
        int i = light_tree_sample(position, normal, number, probability);
        light l = sampled_light_piece(max(i, 0), vec2(0.5));
        sum += i >= 0 ? unhidden_irradiance(l, position, normal) / probability : 0.0;
    }
    return sum / float(AREA_SAMPLES);
}

// The area that a VPL of light `l` stands for there, by flux alone. A light that is near is not missed by chance: few VPLs
// would stand for much light.
float sampled_vpl_area(light many, light l, float measure, vec3 position, vec3 normal) {
    float irradiance = all_unhidden_irradiance(position, normal);
    return measure * many.extent / max(max(irradiance, unhidden_irradiance(l, position, normal)), 1e-30);
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
    vec3 albedo, arrives;
    vec4 specular;
    float away;
    surface s = light_end(from, direction, floatBitsToUint(place) + uint(number), albedo, specular, arrives, away);
    if (!s.present)
        return vpl_even(from, -direction, 0.0, vec3(0.0), 0.0);
    vec3 power = light_intensity(l, direction) * light_in_range(l, away * away) * arrives;
    float area = sampled_vpl_area(many, l, measure, s.position, s.normal);
    vec3 flux = albedo * power * (domain * measure / sampled_light_flux(i));
    vpl v = vpl_even(s.position, s.normal, area, flux, 0.0);
    take_lobe(v, specular, albedo, -direction, -dot(s.normal, direction), 0.0);
    return v;
}
