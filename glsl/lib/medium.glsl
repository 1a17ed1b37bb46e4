// A medium and panes between surfaces, lights and the camera: how much light passes. Without HAS_MEDIUM all light does.
#include "shared/medium.h"

#ifdef HAS_MEDIUM
#include "lib/panes.glsl"

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

// Along a unit direction, and between two points.
vec3 medium_passes_along(vec3 origin, vec3 direction, float metres) {
    return medium_passes(metres) * panes_pass(origin, direction, metres);
}

vec3 medium_passes_between(vec3 a, vec3 b) {
    float metres = distance(a, b);
    return medium_passes_along(a, (b - a) / max(metres, 1e-30), metres);
}

// From a light to a surface; direction: where the light travels; of a light without a place from outside.
vec3 medium_passes_light(vec3 position, vec3 direction, bool has_place, float distance2) {
    vec2 segment = medium_segment(position, -direction, has_place ? sqrt(distance2) : 2.0 * medium.radius);
    return medium_passes(segment.y - segment.x) *
           panes_pass(position, -direction, has_place ? sqrt(distance2) : 4.0 * medium.radius);
}
#else
vec3 medium_passes(float metres) {
    return vec3(1.0);
}

vec3 medium_passes_along(vec3 origin, vec3 direction, float metres) {
    return vec3(1.0);
}

vec3 medium_passes_between(vec3 a, vec3 b) {
    return vec3(1.0);
}

vec3 medium_passes_light(vec3 position, vec3 direction, bool has_place, float distance2) {
    return vec3(1.0);
}
#endif
