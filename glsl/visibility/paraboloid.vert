// Casters into the paraboloid depth maps: instance k draws map k, layer k of the array.
#extension GL_ARB_shader_viewport_layer_array : require
#include "visibility/map_views.glsl"
#include "visibility/paraboloid.glsl"
#include "shared/paraboloid.h"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
#ifdef MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv;
out vec2 surface_uv;
#endif

out vec3 local;
flat out vec2 range;
out float gl_ClipDistance[2];

void main() {
    map_view v = views[gl_InstanceID];
    vec3 q = paraboloid_local(v, position);
    float r = length(q);
    gl_ClipDistance[0] = q.z - params.clip_z;
    // Geometry around the centre would hide all the rest [Dong 2009 Fig. 7].
    gl_ClipDistance[1] = r - v.near;
    // Behind the plane the projection runs off to infinity; what is there is clipped away. The farther off
    // a corner there is drawn, the farther from its true place an edge to it enters the map.
    vec3 direction = q / max(r, 1e-20);
    direction.z = max(direction.z, -0.25);
    gl_Position = vec4(paraboloid_project(direction), r / v.z_far, 1.0);
    gl_Layer = gl_InstanceID;
    local = q;
    range = vec2(v.near, v.z_far);
#ifdef MASKED
    surface_uv = uv;
#endif
}
