// Casters into the paraboloid depth maps: instance k draws map k, layer k of the array.
#extension GL_ARB_shader_viewport_layer_array : require
#include "passes/visibility/map_views.glsl"
#include "passes/visibility/paraboloid.glsl"
#include "shared/maps.h"

PASS_BLOCK(paraboloid_params, 16)

// A corner of a caster, on its way into a paraboloid depth map: places it there.
out vec3 local;
flat out vec2 range;
out float gl_ClipDistance[2];

// Of a view that nobody asks.
void paraboloid_nowhere() {
    gl_ClipDistance[0] = gl_ClipDistance[1] = -1.0;
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    gl_Layer = 0;
    local = vec3(0.0);
    range = vec2(0.0);
}

// q: in the frame of view v, whose map is the layer.
void paraboloid_corner(map_view v, int layer, vec3 q) {
    float r = length(q);
    gl_ClipDistance[0] = paraboloid_above(q);
    // Geometry around the centre would hide all the rest [Dong 2009 Fig. 7].
    gl_ClipDistance[1] = r - v.near;
    // Behind the plane the projection runs off to infinity; what is there is clipped away. The farther off
    // a corner there is drawn, the farther from its true place an edge to it enters the map.
    vec3 direction = q / max(r, 1e-20);
    direction.z = max(direction.z, -0.25);
    // No point of the triangle is nearer than this corner by more than its longest edge, nor is what is interpolated.
    float least = max(r * (1.0 - LEAST_ROUNDING) - params.long_edge, 0.0);
    gl_Position = vec4(paraboloid_project(direction), least / v.z_far, 1.0);
    gl_Layer = layer;
    local = q;
    range = vec2(v.near, 1.0 / v.z_far);
}

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
