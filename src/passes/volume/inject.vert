// A point of a surface, with the light that it reflects, to its voxel in the atlas. PIXELS: the points are what pixels of the
// camera's picture see [Mavridis and Papaioannou 2011 section 3.2].
#include "lib/volume.glsl"
#if CHANNELS == VOLUME_RADIANCE
#include "passes/volume/point_lit.glsl"
#else
// The light of points does not matter to visibility.
vec3 point_irradiance_at(vec3 position, vec3 normal) {
    return vec3(0.0);
}
#endif

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

#ifdef PIXELS
#include "lib/gbuffer.glsl"

layout(binding = UNIT_GBUFFER_ALBEDO) uniform sampler2DArray gbuffer_albedos;

void main() {
    ivec2 size = gbuffer_size(), grid = min(size, ivec2(VOLUME_PIXELS));
    ivec2 place = ivec2(gl_VertexID % VOLUME_PIXELS, gl_VertexID / VOLUME_PIXELS);
    ivec2 pixel = ivec2((vec2(place) + 0.5) * vec2(size) / vec2(grid));
    surface s = gbuffer_surface(min(pixel, size - 1));
    surface_sum = radiosity_sum = back_sum = albedo_sum = vec4(0.0);
    is_turned = 0.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    if (s.present && all(lessThan(place, grid)))
        point_add(s.position, s.normal, albedo_fetch(gbuffer_albedos, ivec3(pixel, 0)), false);
}
#else
layout(location = ATTRIBUTE_POINT_POSITION) in vec3 position;
layout(location = ATTRIBUTE_POINT_NORMAL) in vec4 normal_and_sides; // w > 0: its back reflects, too
layout(location = ATTRIBUTE_POINT_ALBEDO) in vec4 albedo_root;

void main() {
    point_add(position, normalize(normal_and_sides.xyz), albedo_root.rgb * albedo_root.rgb, normal_and_sides.w > 0.0);
}
#endif
