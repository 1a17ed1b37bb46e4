// Draws the scene's depth and normals for antialiasing: instance i to layer i, shifted by its part of a pixel. MASKED: of
// surfaces with holes.
#extension GL_ARB_shader_viewport_layer_array : require
#include "passes/picture/camera_range.glsl"
#include "shared/antialias.h"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
#ifdef MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = ATTRIBUTE_COLOR) in vec4 color;

out vec2 surface_uv;
out vec4 surface_color;
#endif

centroid out vec3 surface_normal;

void main() {
    gl_Position = camera.world_to_clip * vec4(position, 1.0);
    gl_Position.xy += params.shifts[gl_InstanceID].xy * gl_Position.w;
    cut_by_range(gl_Position);
    gl_Layer = gl_InstanceID;
    surface_normal = normal;
#ifdef MASKED
    surface_uv = uv;
    surface_color = color;
#endif
}
