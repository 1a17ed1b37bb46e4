// Draws the scene into a G-buffer: the camera's, or the light's (the reflective shadow map), of which
// instance i is the i-th view. Or the camera's depth alone, for antialiasing, instance i shifted by the
// i-th part of a pixel.
#extension GL_ARB_shader_viewport_layer_array : require
#ifdef LIGHT_VIEW
#include "lib/light.glsl"
#define VIEW light.views[gl_InstanceID]
#else
#include "lib/camera.glsl"
#define VIEW camera
#endif
#ifdef SAMPLE_LAYERS
#include "shared/antialias.h"
#endif

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = ATTRIBUTE_COLOR) in vec4 color;

out vec3 surface_normal;
out vec2 surface_uv;
out vec4 surface_color;

void main() {
    gl_Position = VIEW.world_to_clip * vec4(position, 1.0);
#ifdef SAMPLE_LAYERS
    gl_Position.xy += params.shifts[gl_InstanceID].xy * gl_Position.w;
#endif
    gl_Layer = gl_InstanceID;
    surface_normal = normal;
    surface_uv = uv;
    surface_color = color;
}
