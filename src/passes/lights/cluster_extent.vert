// Each VPL lands on its VAL's pixel with its place in the plane perpendicular to the mean normal, both
// signs, so that MAX blending finds the bounding rectangle in one draw [Dong 2009 §6].
#include "lib/direction.glsl"
#include "shared/cluster.h"
#include "passes/lights/val_distance.glsl"
#include "lib/vpl_input.glsl"

flat out vec4 value;

void main() {
    vpl v = vpl_input();
    int k = int(v.val);
    vec3 tangent = perpendicular(texelFetch(val_normals, ivec2(k, 0), 0).xyz);
    vec3 bitangent = cross(texelFetch(val_normals, ivec2(k, 0), 0).xyz, tangent);
    vec3 from_center = v.position - texelFetch(val_positions, ivec2(k, 0), 0).xyz;
    vec2 st = vec2(dot(from_center, tangent), dot(from_center, bitangent));
    value = vec4(st, -st); // max s, max t, -min s, -min t
    gl_Position = v.reach > 0.0 ? val_pixel(k) : vec4(0.0, 0.0, 2.0, 1.0);
}
