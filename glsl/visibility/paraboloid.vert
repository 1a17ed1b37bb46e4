// Casters into the paraboloid depth maps: instance k draws map k, layer k of the array.
#extension GL_ARB_shader_viewport_layer_array : require
#include "visibility/map_views.glsl"
#include "visibility/paraboloid_corner.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
#ifdef MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv;
out vec2 surface_uv;
#endif

void main() {
    map_view v = map_view_at(gl_InstanceID);
    if (v.near == MAP_VIEW_EMPTY)
        paraboloid_nowhere();
    else
        paraboloid_corner(v, gl_InstanceID, paraboloid_local(v, position));
#ifdef MASKED
    surface_uv = uv;
#endif
}
