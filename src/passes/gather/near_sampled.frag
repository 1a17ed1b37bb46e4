// Near field of sampled lights, by rays from the receiver:
//     E = 1/n sum_j  rho E_y near(d)     y: what ray j meets; E_y: by one light of the tree
#include "passes/gather/receiver.glsl"
#include "passes/gather/vpl_terms.glsl"
#include "lib/random.glsl"
#include "passes/lights/vpl_sampled.glsl"
#include "passes/visibility/shadow_ray.glsl"
#include "lib/vpl_shares.glsl"
#include "passes/lights/vpl_density.glsl"

PASS_BLOCK(near_sampled_params, 32)

layout(location = LOCATION_SLOT) uniform ivec4 slot; // the tile's place in the pattern, in its last two

layout(location = TARGET_RESULT) out vec4 irradiance;

// Irradiance at what a ray meets, as far as it is the near field's.
vec3 near_light(surface end, float away, uvec3 seed) {
    vpl_share share = vpl_share_at(params.many);
    float number = random_of(seed).x, probability;
    int i = end.present ? light_tree_sample(end.position, end.normal, number, probability) : -1;
    if (i < 0)
        return vec3(0.0);
    light l = sampled_light_piece(i, random_of(seed.yzx));
    float area = sampled_vpl_area(light_at(params.many), l, share.measure, end.position, end.normal);
    area = vpl_area_at(area, params.many, sampled_light_place(i, l, end.position));
    vec3 direction = normalize(end.position - l.position);
    float near = near_share(away * away, area, share.reach);
    float weight = near * max(-dot(end.normal, direction), 0.0) / probability;
    return arriving(l, end.position, end.normal, weight, direction);
}

void main() {
    irradiance = vec4(0.0);
    ivec2 pixel;
    bool receives = receiver_pixel(params.pattern, slot.zw, pixel);
    surface s = receiver_surface(pixel);
    if (!receives || !s.present)
        return;
    vec3 facet = receiver_triangle(s, pixel);
    uint first = uint((slot.w * params.pattern.n + slot.z) * params.rays);
    vec2 shift = random_of(uvec3(pixel / params.pattern.n, params.pass));
    for (int ray = 0; ray < params.rays; ray++) {
        uvec2 turns = (first + uint(ray)) * LATTICE_PLASTIC;
        vec2 number = fract(vec2(lattice_number(turns.x), lattice_number(turns.y)) + shift);
        vec3 direction = cosine_direction(s.normal, number);
        bool asks = !is_behind_horizon(facet, direction);
        bvh_hit hit = bvh_meet(s.position + bvh_clearance() * s.normal, direction, asks);
        surface end = surface(asks && hit.triangle >= 0, s.position + hit.distance * direction, hit.normal);
        vec3 albedo = reflected(hit);
        vec3 light = near_light(end, hit.distance, uvec3(pixel, ray + params.rays * params.pass));
        irradiance.rgb += albedo * light * medium_passes_between(s.position, end.position);
    }
    irradiance.rgb *= params.scale / float(params.rays);
}
