// A point of a surface, with the light that it reflects, to its voxel.
#include "lib/volume.glsl"
#include POINT_LIGHT

layout(location = ATTRIBUTE_POINT_POSITION) in vec3 position;
layout(location = ATTRIBUTE_POINT_NORMAL) in vec4 normal_and_sides; // w > 0: its back reflects, too
layout(location = ATTRIBUTE_POINT_ALBEDO) in vec4 albedo_root;

flat out vec4 surface_sum, radiosity_sum, back_sum, albedo_sum;

void main() {
    vec3 place = volume_place(position), normal = normalize(normal_and_sides.xyz);
    vec3 albedo = albedo_root.rgb * albedo_root.rgb;
    float sides = normal_and_sides.w > 0.0 ? 1.0 : 0.0;
    surface_sum = vec4(normal, 1.0);
    radiosity_sum = vec4(albedo * point_irradiance_at(position, normal), 0.0);
    back_sum = vec4(0.0);
    if (sides > 0.0)
        back_sum = vec4(albedo * point_irradiance_at(position, -normal), sides);
    albedo_sum = vec4(albedo, 0.0);
    vec2 texel = vec2(volume_texel(ivec3(place))) + 0.5;
    gl_Position = volume_has(place) ? vec4(texel / params.atlas * 2.0 - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
