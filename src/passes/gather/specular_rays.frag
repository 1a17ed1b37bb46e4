// What a surface that is not diffuse reflects of lit surfaces, found by rays that are sampled by its lobe [Heitz 2018]:
//     L = 1/n sum_j  f_r cos_x / p(l_j)  L_y(-l_j)  share_j
// The surface y that a ray meets has the direct light of its pixel if the camera sees y. Else y takes one light, chosen
// by the light that it gives there if nothing hides it: no choice makes y brighter than all lights do.
// A draw fills one tile of the gather's pattern.
#include "passes/gather/specular_ways.glsl"
#include "lib/random.glsl"
#include "passes/gather/receiver.glsl"
#include "lib/light_domain.glsl"
#include "lib/vpl_shares.glsl"
#include "shared/gather.h"
#include "shared/vpl.h"

PASS_BLOCK(specular_rays_params, 48)

#include "passes/lights/hit_light.glsl"
#include "passes/lights/light_end.glsl"
#include "passes/lights/vpl_density.glsl"

layout(binding = UNIT_GBUFFER_ALBEDO) uniform sampler2DArray gbuffer_albedos;
layout(binding = UNIT_DIRECT) uniform sampler2D direct;
layout(binding = UNIT_IRRADIANCE) uniform sampler2D irradiance;

layout(location = LOCATION_SLOT) uniform ivec4 slot; // the tile's place in the pattern, in its last two

layout(location = TARGET_RESULT) out vec4 radiance;

const float INVERSE_PI = 0.31830988618;

// How much of what the ray finds is the rays' to add: VPLs find the rest.
float share_of_rays(specular_surface seen, surface s, surface end, vec3 direction, chosen_light chosen, float rays) {
    vec3 path = end.position - s.position;
    vpl_share shares = vpl_share_at(chosen.index);
    light l = light_at(chosen.index);
    float area = chosen.distance2 / max(chosen.cosine, VPL_COSINE_MIN) * shares.measure;
    vec2 place = light_domain_place(l, end.position);
#ifdef HAS_SAMPLED
    if (chosen.sampled >= 0) {
        light own = sampled_light_middle(chosen.sampled);
        area = sampled_vpl_area(l, own, shares.measure, end.position, end.normal);
        place = sampled_light_place(chosen.sampled, own, end.position);
    }
#endif
    area = vpl_area_at(area, chosen.index, place);
    specular_densities there = specular_densities_at(seen, direction, -dot(end.normal, direction), dot(path, path),
                                                     rays, area * params.vpl_weight);
    return specular_weight(there.rays, there.vpls);
}

// A pixel's albedo, as if all that its lobe does not mirror towards the eye were diffuse.
vec3 pixel_albedo(ivec2 pixel) {
    specular_surface own = gbuffer_specular(gbuffer_surface(pixel), pixel);
    vec3 lobe = specular_albedo(own.f0, own.f90, own.alpha, dot(own.normal, own.to_eye));
    return albedo_fetch(gbuffer_albedos, ivec3(pixel, 0)) / max(1.0 - lobe, 0.1);
}

// The indirect light that the surface sends, by the frame's irradiance there. Where the camera does not see the
// surface, the receiver's irradiance stands for it.
vec3 sent_later(vec3 albedo, ivec2 pixel) {
#if ADDS_LATER
    return albedo * texelFetch(irradiance, pixel, 0).rgb * (INVERSE_PI / params.scale);
#else
    return vec3(0.0);
#endif
}

// The radiance that a ray of pixel `own` finds, as far as it is the rays' to add.
vec3 found(surface s, specular_surface seen, vec3 direction, ivec2 own, uint seed, bool asks) {
    bvh_hit hit = bvh_meet(s.position + bvh_clearance() * s.normal, direction, asks);
    surface end = surface(asks && hit.triangle >= 0, s.position + hit.distance * direction, hit.normal);
    vec2 random = random_of(uvec3(own, seed));
    chosen_light chosen = choose_light(end, random.x);
    if (!end.present)
        return vec3(0.0);
    ivec2 pixel;
    bool on_screen = camera_sees(end.position, end.normal, pixel);
    vec3 albedo = on_screen ? pixel_albedo(pixel) : reflected(hit);
    vec3 later = sent_later(albedo, on_screen ? pixel : own), sent = vec3(0.0);
    if (chosen.share > 0.0) {
        float rays = specular_effort(seen) * float(params.rays) / (on_screen ? 1.0 : float(light_count));
        sent = on_screen ? albedo * texelFetch(direct, pixel, 0).rgb
                         : hit_radiance(end, albedo, reflected_specular(hit), chosen, -direction, seen.alpha, random.y);
        sent *= share_of_rays(seen, s, end, direction, chosen, rays);
    }
    return (sent + later) * medium_passes_between(s.position, end.position);
}

void main() {
    radiance = vec4(0.0);
    ivec2 pixel;
    bool receives = receiver_pixel(params.pattern, slot.zw, pixel);
    surface s = receiver_surface(pixel);
    specular_surface seen = gbuffer_specular(s, pixel);
    if (!receives || !s.present || seen.f90 == vec3(0.0))
        return;
    vec3 facet = receiver_triangle(s, pixel);
    int rays = max(int(float(params.rays) * specular_effort(seen)), 1);
    for (int ray = 0; ray < rays; ray++) {
        vec2 place = pixel_sample(pixel, params.start, ray);
        vec3 direction = lobe_sample(seen, place);
        float density = lobe_density(seen, direction);
        bool asks = dot(direction, s.normal) > 0.0 && !is_behind_horizon(facet, direction) && density > 0.0;
        vec3 reflects = asks ? specular_brdf(seen, direction) / density : vec3(0.0);
        radiance.rgb += reflects * found(s, seen, direction, pixel, floatBitsToUint(place.x), asks);
    }
    radiance.rgb *= params.scale / float(rays);
}
