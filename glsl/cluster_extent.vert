// Each VPL lands on its VAL's pixel with its place in the plane perpendicular to the mean normal, both
// signs, so that MAX blending finds the bounding rectangle in one draw [Dong 2009 §6].
#include "lib/val_distance.glsl"
#include "lib/tangent.glsl"

layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position; // w: C(i)
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal;
layout(location = ATTRIBUTE_VPL_FLUX) in vec4 flux;

flat out vec4 place;

void main() {
    int k = int(position.w);
    vec3 tangent = perpendicular(texelFetch(val_normals, ivec2(k, 0), 0).xyz);
    vec3 bitangent = cross(texelFetch(val_normals, ivec2(k, 0), 0).xyz, tangent);
    vec3 from_center = position.xyz - texelFetch(val_positions, ivec2(k, 0), 0).xyz;
    vec2 st = vec2(dot(from_center, tangent), dot(from_center, bitangent));
    place = vec4(st, -st);
    gl_PointSize = 1.0;
    gl_Position = flux.w > 0.0 ? val_pixel(k) : vec4(0.0, 0.0, 2.0, 1.0);
}
