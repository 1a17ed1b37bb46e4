// A medium between surfaces, lights and the camera.
#include "shared/medium.h"

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

// The share of light that passes so many metres of the medium.
vec3 medium_passes(float metres) {
    return exp(-medium.extinction * max(metres, 0.0));
}

// What of a light comes to a point of the medium, from so far away in that unit direction.
vec3 medium_passes_from(vec3 position, vec3 to_light, float away) {
    vec2 segment = medium_segment(position, to_light, away);
    return medium_passes(segment.y - segment.x);
}
