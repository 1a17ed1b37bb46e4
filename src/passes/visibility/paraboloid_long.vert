// The corners of a long caster, in the frame of the map that instance k draws, for paraboloid_long.geom.
#include "passes/visibility/map_views.glsl"
#include "passes/visibility/paraboloid.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
#ifdef MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv;
out vec2 corner_uv;
#endif

out vec3 corner;
out int map;

void main() {
    corner = paraboloid_local(map_view_at(gl_InstanceID), position);
    map = gl_InstanceID;
#ifdef MASKED
    corner_uv = uv;
#endif
}
