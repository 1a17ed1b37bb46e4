// Casters into the orthographic maps of a sky's lights: instance k draws layer k of the array. Depth is linear, 1 is
// far.
#extension GL_ARB_shader_viewport_layer_array : require
#include "lib/sky.glsl"
#include "visibility/sky_maps.glsl"

layout(location = LOCATION_SET_BACK) uniform float set_back; // of casters, metres

layout(location = ATTRIBUTE_POSITION) in vec3 position;
#ifdef MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv;
out vec2 surface_uv;
#endif

void main() {
    sky_maps_of maps = sky_maps_at(light_of_layer(gl_InstanceID));
    sky_view v = sky_view_at(maps.light);
    int number = gl_InstanceID - maps.first;
    ivec2 map = ivec2(number % maps.side, number / maps.side);
    vec3 from = position - v.origin;
    vec2 aside = vec2(dot(from, v.right), dot(from, v.up)) / v.half_size;
    aside = aside * float(maps.side) + float(maps.side - 1) - 2.0 * vec2(map);
    gl_Position = vec4(aside, (dot(from, v.forward) + set_back) / v.far, 1.0);
    gl_Layer = gl_InstanceID;
#ifdef MASKED
    surface_uv = uv;
#endif
}
