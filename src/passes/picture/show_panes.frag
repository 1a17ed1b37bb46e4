// What panes before the surfaces of the picture let pass to the camera, and their own light: diffuse light as the nearest
// reflecting pane receives it, direct light of panes behind that by shadow rays, and the sky that glass reflects.
#include "lib/direction.glsl"
#include "lib/gbuffer.glsl"
#include "passes/visibility/shadow_ray.glsl"
#include "shared/show_panes.h"

layout(location = TARGET_RESULT) out vec4 own;
layout(location = TARGET_TRANSMITTANCE) out vec4 passes;

#ifdef HAS_AIRLIGHT
layout(binding = UNIT_BEHIND_IN_SCATTER) uniform sampler2D in_scatters;
layout(binding = UNIT_BEHIND_TRANSMITTANCE) uniform sampler2D transmittances;
#endif
#ifdef HAS_SKY
layout(binding = UNIT_PANES_SKY) uniform sampler2D sky;
#endif
#ifdef HAS_SURFACES // passes/picture/pane_surfaces.frag
layout(binding = UNIT_DIRECT) uniform sampler2D directs;
#endif
#ifdef HAS_IRRADIANCE
layout(binding = UNIT_IRRADIANCE) uniform sampler2D irradiances;
#endif

const float PI = 3.14159265;

// Direct light over pi of a white surface on that side.
vec3 direct_at(vec3 place, vec3 normal) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count; i++)
        sum += irradiance_from(light_at(i), place, normal, normal);
    return sum / PI;
}

vec3 sky_along(vec3 origin, vec3 direction) {
#ifdef HAS_SKY
    if (!bvh_meets_any(bvh_ray_along(origin, direction, BVH_FAR), true))
        return params.sky_strength * panorama_texel(sky, direction, params.sky_turn);
#endif
    return vec3(0.0);
}

// Over pi, times the scale.
vec3 arriving(vec3 place, vec3 normal, ivec2 pixel, bool nearest) {
    vec3 sum = vec3(0.0);
#ifdef HAS_IRRADIANCE
    sum = texelFetch(irradiances, pixel, 0).rgb / PI;
#endif
#ifdef HAS_SURFACES
    if (nearest)
        return sum + params.scale * texelFetch(directs, pixel, 0).rgb;
#endif
    return sum + params.scale * direct_at(place, normal);
}

vec3 own_light(pane p, vec3 place, vec3 direction, ivec2 pixel, inout bool nearest) {
    vec3 normal = dot(p.normal, direction) < 0.0 ? p.normal : -p.normal;
    float covers = 1.0 - p.base;
    vec3 albedo = pane_albedo(p, direction), sum = vec3(0.0);
    if (albedo != vec3(0.0)) {
        sum = albedo * arriving(place + panes_clearance() * normal, normal, pixel, nearest);
        nearest = false;
    }
    float reflects = p.glass > 0.0 ? covers * (1.0 - plate_passes(p, direction)) : 0.0;
    if (reflects > 0.0)
        sum += params.scale * reflects * sky_along(place + bvh_clearance() * normal, reflect(direction, normal));
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    sight ray = sight_of(pixel);
    float start = 0.0;
    vec3 before = vec3(1.0);
    bool nearest = true; // of those that reflect diffusely
    own = vec4(0.0, 0.0, 0.0, 1.0);
    for (int layer = 0; layer < PANE_LAYERS; layer++) {
        panes_met met = panes_meet(ray.origin, ray.direction, start, ray.ray_length);
        if (met.nearest >= ray.ray_length)
            break;
        pane p = pane_at(met.texel);
        if (p.both || dot(p.normal, ray.direction) < 0.0) { // the camera sees no backs of one side
            own.rgb += before * medium_alone(ray.origin, ray.direction, met.nearest) *
                       own_light(p, ray.origin + met.nearest * ray.direction, ray.direction, pixel, nearest);
            before *= pane_passes(p, ray.direction);
        }
        start = met.nearest * (1.0 + PANE_EDGE);
    }
    passes = vec4(before, dot(before, vec3(1.0 / 3.0))); // A: without the medium
#ifdef HAS_AIRLIGHT
    own.rgb += texelFetch(in_scatters, pixel, 0).rgb;
    passes.rgb *= texelFetch(transmittances, pixel, 0).rgb;
#endif
}
