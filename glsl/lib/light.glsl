#include "lib/view.glsl"
#include "shared/light.h"

layout(std140, binding = BLOCK_LIGHTS) uniform light_uniforms {
    light_block lights;
};

// The spot's falloff by KHR_lights_punctual.
float light_cone(light l, float cos_angle) {
    float span = max(0.001, l.cos_inner - l.cos_outer);
    float t = clamp((cos_angle - l.cos_outer) / span, 0.0, 1.0);
    return t * t;
}

// Intensity of a spot or point light in a unit direction, W/sr.
vec3 light_intensity(light l, vec3 direction) {
    float cone = l.type == LIGHT_TYPE_SPOT ? light_cone(l, dot(direction, l.direction)) : 1.0;
    return l.intensity * cone;
}

// Which view of the light sees in this direction: +x -x +y -y +z -z of six.
int light_view_index(light l, vec3 direction) {
    if (l.view_count < 2)
        return l.first_view;
    vec3 a = abs(direction);
    int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return l.first_view + 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}
