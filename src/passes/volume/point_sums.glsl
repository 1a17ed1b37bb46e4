// What a point of a surface adds to its voxel, and where in the atlas that is.
#include "lib/volume.glsl"
#include POINT_LIGHT

flat out vec4 surface_sum, radiosity_sum, back_sum, albedo_sum;
flat out float is_turned;

// Few walls lie along it: the two sides of a thin wall are turned away from it and towards it.
const vec3 SPLIT_DIRECTION = vec3(0.62, 0.59, 0.51);

void point_add(vec3 position, vec3 normal, vec3 albedo, bool two_sided) {
    vec3 place = volume_place(position);
    surface_sum = vec4(normal, 1.0);
    // How far the surface's plane is from the voxel's middle, too.
    radiosity_sum = vec4(albedo * point_irradiance_at(position, normal), dot(normal, fract(place) - 0.5));
    is_turned = dot(normal, SPLIT_DIRECTION) < 0.0 ? 1.0 : 0.0;
    back_sum = vec4(0.0);
    if (two_sided)
        back_sum = vec4(albedo * point_irradiance_at(position, -normal), 1.0);
    albedo_sum = vec4(albedo, 0.0);
    vec2 texel = vec2(volume_texel(ivec3(place))) + 0.5;
    gl_Position = volume_has(place) ? vec4(texel / params.atlas * 2.0 - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
