// What a point of a surface adds to its voxel, and where in the atlas that is.
#include "lib/volume.glsl"
#include POINT_LIGHT

flat out vec4 surface_sum, radiosity_sum, back_sum, albedo_sum;

void point_add(vec3 position, vec3 normal, vec3 albedo, bool two_sided) {
    vec3 place = volume_place(position);
    surface_sum = vec4(normal, 1.0);
    radiosity_sum = vec4(albedo * point_irradiance_at(position, normal), 0.0);
    back_sum = vec4(0.0);
    if (two_sided)
        back_sum = vec4(albedo * point_irradiance_at(position, -normal), 1.0);
    albedo_sum = vec4(albedo, 0.0);
    vec2 texel = vec2(volume_texel(ivec3(place))) + 0.5;
    gl_Position = volume_has(place) ? vec4(texel / params.atlas * 2.0 - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
