// Casters into the orthographic maps of a sky's lights: instance k draws map k, layer k of the array. Depth is
// linear, 1 is far.
#extension GL_ARB_shader_viewport_layer_array : require
#include "lib/sky.glsl"

layout(location = LOCATION_SET_BACK) uniform float set_back; // of casters, metres

layout(location = ATTRIBUTE_POSITION) in vec3 position;
#ifdef MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv;
out vec2 surface_uv;
#endif

void main() {
    sky_view v = sky_view_at(gl_InstanceID);
    vec3 from = position - v.origin;
    vec2 aside = vec2(dot(from, v.right), dot(from, v.up)) / v.half_size;
    gl_Position = vec4(aside, (dot(from, v.forward) + set_back) / v.far, 1.0);
    gl_Layer = gl_InstanceID;
#ifdef MASKED
    surface_uv = uv;
#endif
}
