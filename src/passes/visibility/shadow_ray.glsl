// Light of one light at a place, by a shadow ray.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "passes/visibility/bvh.glsl"

vec3 arriving_unshadowed(light l, vec3 place, out vec3 direction, out float away) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    float distance2;
    vec3 power = light_towards(l, place, direction, distance2);
    away = directional ? BVH_FAR : sqrt(distance2);
    return power / distance2 * medium_passes_light(place, direction, !directional, distance2);
}

// Across its direction, W/m2; above: which side of a surface rays start on, or 0.
vec3 arriving(light l, vec3 place, vec3 above, float weight, out vec3 direction) {
    float away, clearance = bvh_clearance();
    vec3 power = weight * arriving_unshadowed(l, place, direction, away);
    bool asks = dot(power, vec3(1.0)) > 0.0 && away > clearance;
    // It ends before the light, which may lie on a surface.
    vec3 origin = place + clearance * above, way = -direction;
    if (l.type != LIGHT_TYPE_DIRECTIONAL)
        way = (l.position - origin) / away;
    bvh_ray ray = bvh_ray_along(origin, way, away - clearance);
    return asks && !bvh_meets_any(ray, asks) ? power : vec3(0.0);
}

vec3 irradiance_from(light l, vec3 place, vec3 normal, vec3 flat_normal) {
    vec3 direction, unused;
    float away;
    arriving_unshadowed(l, place, direction, away);
    float cosine = dot(flat_normal, direction) < 0.0 ? max(-dot(normal, direction), 0.0) : 0.0;
    return arriving(l, place, flat_normal, cosine, unused);
}
