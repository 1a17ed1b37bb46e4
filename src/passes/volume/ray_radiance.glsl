// Rays of indirect light: the radiance that leaves the surfaces of the voxel that is met, to the side where it is met.
#include "lib/medium.glsl"
#include "lib/volume.glsl"

#define gathered vec3

layout(binding = UNIT_VOLUME_RADIOSITY) uniform sampler2D radiosities;
#if BACKS
layout(binding = UNIT_VOLUME_BACK) uniform sampler2D backs;
#endif
#if SPLIT
layout(binding = UNIT_VOLUME_TURNED_RADIOSITY) uniform sampler2D turned_radiosities;

// Of a side's radiosity, by how much it faces the ray; w: its weight.
vec4 side_light(vec4 side, vec3 radiosity, vec3 direction) {
    float facing = side.a > 0.5 ? max(-dot(side.xyz, direction) / side.a, 0.0) : 0.0;
    return vec4(radiosity / max(side.a, 1.0), 1.0) * facing;
}
#endif

vec3 leaving(ivec3 voxel, vec3 direction) {
    ivec2 texel = volume_texel(voxel);
    vec4 surface = texelFetch(surfaces, texel, 0), back = vec4(0.0);
    vec3 front = texelFetch(radiosities, texel, 0).rgb;
#if BACKS
    back = texelFetch(backs, texel, 0);
#endif
#if SPLIT
    if (has_sides(surface)) {
        vec4 turned = texelFetch(turned_surfaces, texel, 0);
        vec3 radiosity = texelFetch(turned_radiosities, texel, 0).rgb;
        vec4 sum = side_light(turned, radiosity, direction) + side_light(surface - turned, front - radiosity, direction);
        return sum.rgb * (0.31830989 / max(sum.a, 1e-6));
    }
    return (dot(surface.xyz, direction) < 0.0 ? front : back.rgb) * (0.31830989 / surface.a);
#else
    // As published: spherical harmonics of order 2 of a half space that shines.
    return max(front * (0.31830989 / surface.a * (0.5 - 0.75 * dot(surface.xyz / surface.a, direction))), 0.0);
#endif
}

gathered ray_end(ivec3 voxel, bool met, vec3 origin, vec3 direction, float metres) {
    return met ? leaving(voxel, direction) * medium_passes_along(origin, direction, metres) : vec3(0.0);
}
