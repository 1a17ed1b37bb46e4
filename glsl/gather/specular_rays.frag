// What a surface that is not diffuse reflects of the light that rays find, sampled by its lobe, in the lights' maps:
//     L = 1/n sum_j  f_r cos_x / p(l_j)  rho I cos_y / (pi d^2)  share_j
// A draw fills one tile, whose pixels take the same lights, as in the near field.
#include "lib/gbuffer_specular.glsl"
#include "lib/lobe_albedo.glsl"
#include "lib/medium.glsl"
#include "gather/receiver_all.glsl"
#include "gather/specular_weight.glsl"
#include "gather/light_march.glsl"
#include "gather/near_field.glsl"
#include "lib/vpl_shares.glsl"
#include "shared/specular_rays.h"
#include "shared/vpl.h"
#include VPL_AREA
#if VAL_COUNT > 0
#include "visibility/visibility.glsl"
#endif

layout(binding = UNIT_RSM_SPECULAR) uniform sampler2DArray rsm_speculars[LIGHT_MAP_KINDS];

layout(location = LOCATION_SLOT) uniform ivec4 slot; // the tile's place in the pattern, in its last two
// The lights that this tile takes, and each one's weight: of a group of many one stands for all.
layout(location = LOCATION_SLOT_LIGHT_COUNT) uniform int slot_light_count;
layout(location = LOCATION_SLOT_LIGHTS) uniform vec2 slot_lights[LIGHTS];

layout(location = TARGET_RESULT) out vec4 radiance;

// Until the ray has left the scene, metres: well behind a wall that bounds it.
float farthest(vec3 origin, vec3 direction) {
    vec3 a = (params.bounds_min - origin) / direction, b = (params.bounds_max - origin) / direction;
    vec3 leaves = max(a, b);
    float beyond = 0.05 * distance(params.bounds_min, params.bounds_max);
    return max(min(min(leaves.x, leaves.y), leaves.z), 0.0) + beyond;
}

// Two numbers of [0, 1) for each pixel and ray: neighbours' lie far apart, and so do one pixel's.
vec2 sample_of(ivec2 pixel, int ray) {
    const vec2 STEP = vec2(SPECULAR_STEP_X, SPECULAR_STEP_Y);
    vec2 shift = vec2(dot(vec2(pixel), STEP), dot(vec2(pixel), vec2(0.8191725134, 0.6710436067)));
    return fract(fract(shift) + params.start + float(ray) * STEP);
}

vec4 hit_specular_code(march_hit hit) {
    ivec3 place = ivec3(hit.texel, hit.seen_by.layer);
    return hit.seen_by.kind == LIGHT_MAP_FACE ? texelFetch(rsm_speculars[LIGHT_MAP_FACE], place, 0)
                                              : texelFetch(rsm_speculars[LIGHT_MAP_SINGLE], place, 0);
}

// What of the light's irradiance the hit surface sends to the receiver, 1/sr times the light's cosine there. Few rays of a
// rough receiver would find a highlight, as spots: its lobe is as much wider as the receiver's is [Kaplanyan and
// Dachsbacher 2013]. Diffuse is what the map's albedo has beside the specular part (picture/surface_detail.glsl).
vec3 hit_reflects(march_hit hit, vec3 to_light, vec3 to_receiver, float cosine, float receiver_alpha) {
    vec4 code = hit_specular_code(hit), specular = specular_decode(code);
    vec3 f90 = specular_grazing(code), light_away = facing(hit.end.normal, to_light);
    vec3 lobe = specular_albedo(specular.rgb, f90, specular_alpha(specular.a), dot(hit.end.normal, light_away));
    vec3 diffuse = max(rsm_albedo(hit.seen_by, hit.texel) - lobe, 0.0);
    float alpha = min(length(vec2(specular.a * specular.a, receiver_alpha)), 1.0);
    specular_surface s = specular_surface(specular.rgb, f90, alpha, hit.end.normal, facing(hit.end.normal, to_receiver));
    return diffuse * (cosine / 3.14159265) + (specular.rgb == vec3(0.0) ? vec3(0.0) : specular_brdf(s, to_light));
}

// The radiance of the hit surface, and the area that a VPL has there, over the solid angle that it stands for.
vec3 sent_back(light l, march_hit hit, vec3 to_receiver, float receiver_alpha, out float area) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 from_light = hit.end.position - l.position;
    float distance2 = directional ? 1.0 : dot(from_light, from_light);
    vec3 incoming = directional ? l.direction : from_light * inversesqrt(distance2);
    float cosine = max(dot(hit.end.normal, -incoming), 0.0);
    vec3 power = directional ? l.intensity : light_intensity(l, incoming) * light_in_range(l, distance2);
    area = distance2 / max(cosine, VPL_COSINE_MIN);
    power *= medium_passes_light(hit.end.position, incoming, !directional, distance2);
    return hit_reflects(hit, -incoming, to_receiver, cosine, receiver_alpha) * power / distance2;
}

// What VALs know to hide the end of a ray that was in the dark in between.
float arrives(surface s, surface end) {
#if VAL_COUNT > 0
    int nearest = 0;
    float least = 1e30;
    for (int k = 0; k < VAL_COUNT; k++) {
        map_view v = map_view_at(k);
        float apart = distance(v.center, end.position) * (1.5 - dot(v.axis, end.normal));
        nearest = apart < least ? k : nearest;
        least = min(apart, least);
    }
    return visibility_from(nearest, s.position, s.normal, end.position);
#else
    return 1.0;
#endif
}

vec3 from_light(surface s, specular_surface seen, vec3 direction, float far, int index, float jitter) {
    light l = light_at(index);
    light_view v = light_view_at(light_view_index(l, s.position - l.position));
    vec3 origin = s.position + s.normal * (1.5 * march_texel(v, s.position));
    march_hit hit = light_march(l, origin, direction, far, jitter);
    if (!hit.found)
        return vec3(0.0);
    float area;
    vec3 sent = sent_back(l, hit, -direction, seen.alpha, area);
    vec3 path = hit.end.position - s.position;
    float distance2 = dot(path, path);
    vpl_share shares = vpl_share_at(index);
    area = vpl_area_at(area * shares.measure, index, l, hit.end.position);
    float visible = 1.0;
    for (int dark = hit.in_light ? 0 : 1; dark > 0; dark--) // what is near counts as unoccluded, as of VPLs
        visible = mix(arrives(s, hit.end), 1.0, near_share(distance2, area, shares.reach));
    specular_densities there = specular_densities_at(seen, direction, -dot(hit.end.normal, direction), distance2,
                                                     params.rays, area * params.vpl_weight);
    sent *= medium_passes_between(s.position, hit.end.position);
    return sent * (specular_weight(there.rays, there.vpls) * visible);
}

void main() {
    radiance = vec4(0.0);
    ivec2 pixel;
    if (!receiver_pixel(params.pattern, slot.zw, pixel))
        return;
    surface s = receiver_surface(pixel);
    if (!s.present)
        return;
    specular_surface seen = gbuffer_specular(s, pixel);
    if (seen.f90 == vec3(0.0))
        return;
    bool all_lights = is_smooth(seen.alpha);
    int count = all_lights ? light_count : slot_light_count;
    vec3 facet = receiver_triangle(s, pixel);
    for (int ray = 0; ray < params.rays; ray++) {
        vec2 place = sample_of(pixel, ray);
        vec3 direction = lobe_sample(seen, place);
        float density = lobe_density(seen, direction);
        if (dot(direction, s.normal) <= 0.0 || is_behind_horizon(facet, direction) || density <= 0.0)
            continue;
        float far = farthest(s.position, direction);
        vec3 share = specular_brdf(seen, direction) / density, sum = vec3(0.0);
        for (int i = 0; i < count; i++) {
            vec2 item = all_lights ? vec2(float(i), 1.0) : slot_lights[i];
            sum += item.y * from_light(s, seen, direction, far, int(item.x), fract(17.0 * (place.x + place.y)));
        }
        radiance.rgb += sum * share;
    }
    radiance.rgb *= params.scale / float(params.rays);
}
