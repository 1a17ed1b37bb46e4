// A point of a surface, with the light that it reflects, to its voxel.
#include "passes/volume/point_sums.glsl"

layout(location = ATTRIBUTE_POINT_POSITION) in vec3 position;
layout(location = ATTRIBUTE_POINT_NORMAL) in vec4 normal_and_sides; // w > 0: its back reflects, too
layout(location = ATTRIBUTE_POINT_ALBEDO) in vec4 albedo_root;

void main() {
    point_add(position, normalize(normal_and_sides.xyz), albedo_root.rgb * albedo_root.rgb, normal_and_sides.w > 0.0);
}
