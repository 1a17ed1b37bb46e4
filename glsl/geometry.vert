// Draws the scene into a G-buffer: the camera's, or the light's (the reflective shadow map), of which
// instance i is the i-th view.
#extension GL_ARB_shader_viewport_layer_array : require
#include "shared/light.h"

#ifdef LIGHT_VIEW
layout(std140, binding = BLOCK_LIGHT) uniform light_uniforms {
    light_block light;
};
#define VIEW light.views[gl_InstanceID]
#else
layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
#define VIEW camera
#endif

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;

out vec3 surface_normal;
out vec2 surface_uv;
out vec4 surface_color;

void main() {
    gl_Position = VIEW.world_to_clip * vec4(position, 1.0);
    gl_Layer = gl_InstanceID;
    surface_normal = normal;
    surface_uv = uv;
    surface_color = color;
}
