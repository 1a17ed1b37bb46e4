// A point's disk in an imperfect shadow map. Texels show it whose middle it covers.
#include "lib/direction.glsl"
#include "passes/visibility/paraboloid.glsl"
#include "shared/splat.h"

PASS_BLOCK(splat_params, 32)

flat in vec3 center, normal;
flat in float map_depth;
flat in vec2 radius_and_unit;
flat in float width;

#if SPLAT == SPLAT_DISK
layout(location = TARGET_RESULT) out vec2 normal_code;

void main() {
    vec3 direction = paraboloid_direction(gl_FragCoord.xy / params.map_size * 2.0 - 1.0);
    float facing = dot(normal, direction);
    float met = dot(normal, center) / (abs(facing) > 1e-6 ? facing : 1e-6);
    vec3 from_center = direction * met - center;
    bool inside = dot(from_center, from_center) <= radius_and_unit.x * radius_and_unit.x;
    if (!inside)
        discard;
    float distance = map_depth * radius_and_unit.y;
    gl_FragDepth = clamp(met, 0.5 * distance, 2.0 * distance) / radius_and_unit.y;
    normal_code = octahedral_encode(normal);
}
#else
void main() {
}
#endif
