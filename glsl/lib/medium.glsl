// A medium and panes between surfaces, lights and the camera: how much light passes. Without HAS_MEDIUM all light does.
#include "lib/view.glsl"
#include "shared/medium.h"

const float MEDIUM_FAR = 1e30;

float max_of(vec3 color) {
    return max(color.r, max(color.g, color.b));
}

#ifdef HAS_MEDIUM
#include "lib/panes.glsl"
#include "lib/random.glsl"

layout(std140, binding = BLOCK_MEDIUM) uniform medium_uniforms {
    medium_params medium;
};

// From where to where a ray of that unit direction and length is in the medium, metres; empty where the second is no
// greater.
vec2 medium_segment(vec3 origin, vec3 direction, float ray_length) {
    vec3 from_center = origin - medium.center;
    float along = -dot(from_center, direction);
    vec3 aside = from_center + along * direction;
    float half_chord = sqrt(max(medium.radius * medium.radius - dot(aside, aside), 0.0));
    return vec2(max(along - half_chord, 0.0), min(along + half_chord, ray_length));
}

// So many metres of the medium.
vec3 medium_passes(float metres) {
    return exp(-medium.extinction * max(metres, 0.0));
}

// Along a unit direction: the medium alone; panes alone.
vec3 medium_alone(vec3 origin, vec3 direction, float metres) {
    vec2 segment = medium_segment(origin, direction, metres);
    return medium_passes(segment.y - segment.x);
}

vec3 medium_panes(vec3 origin, vec3 direction, float metres) {
    return panes_pass(origin, direction, metres);
}

// Sends light along a unit direction, from a place or from without, to a surface, or by chance to a pane before it, which
// `end` then is. What arrives, over the chance, but for the surface's albedo; a pane's albedo is in it.
vec3 medium_sends(vec3 place, vec3 direction, bool has_place, uvec2 seed, inout surface end, inout vec3 albedo) {
    float metres = has_place ? distance(place, end.position) : 4.0 * medium.radius, chance = random_of(uvec3(seed, 0)).x;
    vec3 origin = has_place ? place : end.position - metres * direction, share, normal;
    metres = end.present ? metres : MEDIUM_FAR;
    if (panes_stop(origin, direction, chance, metres, share, normal)) {
        end = surface(true, origin + metres * direction + panes_clearance() * normal, normal);
        albedo = vec3(1.0);
    }
    return share * medium_alone(origin, direction, metres);
}
#else
vec3 medium_passes(float metres) {
    return vec3(1.0);
}

vec3 medium_alone(vec3 origin, vec3 direction, float metres) {
    return vec3(1.0);
}

vec3 medium_panes(vec3 origin, vec3 direction, float metres) {
    return vec3(1.0);
}

vec3 medium_sends(vec3 place, vec3 direction, bool has_place, uvec2 seed, inout surface end, inout vec3 albedo) {
    return vec3(1.0);
}
#endif

// Both.
vec3 medium_passes_along(vec3 origin, vec3 direction, float metres) {
    return medium_alone(origin, direction, metres) * medium_panes(origin, direction, metres);
}

// Between two points.
vec3 medium_passes_between(vec3 a, vec3 b) {
    float metres = distance(a, b);
    return medium_passes_along(a, (b - a) / max(metres, 1e-30), metres);
}

// From a light to a surface; direction: where the light travels; of a light without a place from outside.
vec3 medium_passes_light(vec3 position, vec3 direction, bool has_place, float distance2) {
    return medium_passes_along(position, -direction, has_place ? sqrt(distance2) : MEDIUM_FAR);
}
