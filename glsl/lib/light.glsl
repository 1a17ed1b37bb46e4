#include "lib/view.glsl"
#include "shared/light.h"

layout(std140, binding = BLOCK_LIGHT) uniform light_uniforms {
    light_block light;
};

// The spot's falloff by KHR_lights_punctual.
float light_cone(float cos_angle) {
    float span = max(0.001, light.cos_inner - light.cos_outer);
    float t = clamp((cos_angle - light.cos_outer) / span, 0.0, 1.0);
    return t * t;
}

// Intensity of a spot or point light in a unit direction, W/sr.
vec3 light_intensity(vec3 direction) {
    float cone = light.type == LIGHT_TYPE_SPOT ? light_cone(dot(direction, light.direction)) : 1.0;
    return light.intensity * cone;
}

// Which of the light's views sees in this direction: +x -x +y -y +z -z of six.
int light_view_index(vec3 direction) {
    if (light.view_count < 2)
        return 0;
    vec3 a = abs(direction);
    int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}
