// The domain of a light: the unit square, even over what the light shines into. This is solid angle for a spot's cone, an
// area light's half space and a point light's sphere. It is the area of the view for a directional light.
#include "lib/light.glsl"

const float LIGHT_DOMAIN_PI = 3.14159265358979;

float light_domain_end(light l) {
    return l.type == LIGHT_TYPE_SPOT ? l.cos_outer : l.type == LIGHT_TYPE_AREA ? 0.0 : -1.0;
}

// Not of a directional light.
vec3 light_domain_direction(light l, vec2 place) {
    float z = mix(1.0, light_domain_end(l), place.x), azimuth = 2.0 * LIGHT_DOMAIN_PI * place.y;
    vec2 r = sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(azimuth), sin(azimuth));
    return r.x * l.right + r.y * l.up + z * l.direction;
}

// Where a point lies in it; beyond [0, 1]: outside.
vec2 light_domain_place(light l, vec3 position) {
    if (l.type == LIGHT_TYPE_DIRECTIONAL) {
        vec4 clip = light_view_at(l.first_view).view.world_to_clip * vec4(position, 1.0);
        return clip.xy / clip.w * 0.5 + 0.5;
    }
    vec3 direction = normalize(position - l.position);
    float azimuth = atan(dot(direction, l.up), dot(direction, l.right)) / (2.0 * LIGHT_DOMAIN_PI);
    return vec2((1.0 - dot(direction, l.direction)) / (1.0 - light_domain_end(l)), fract(azimuth));
}
