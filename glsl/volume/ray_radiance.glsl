// Rays of indirect light: the radiance that leaves the surfaces of the voxel that is met, to the side where it is met.
#define gathered vec3

layout(binding = UNIT_VOLUME_SURFACES) uniform sampler2D surfaces;
layout(binding = UNIT_VOLUME_RADIOSITY) uniform sampler2D radiosities;
#if BACKS
layout(binding = UNIT_VOLUME_BACK) uniform sampler2D backs;
#endif

// Below this part of their number normals show both ways, as those of a thin wall's two sides: light leaves to all sides.
const float FACING = 0.5;

gathered ray_end(ivec3 voxel, bool met, vec3 direction) {
    if (!met)
        return vec3(0.0);
    ivec2 texel = volume_texel(voxel);
    vec4 surface = texelFetch(surfaces, texel, 0), back = vec4(0.0);
    vec3 front = texelFetch(radiosities, texel, 0).rgb;
#if BACKS
    back = texelFetch(backs, texel, 0);
#endif
#if PUBLISHED
    // Spherical harmonics of order 2 of a half space that shines.
    return max(front * (0.31830989 / surface.a * (0.5 - 0.75 * dot(surface.xyz / surface.a, direction))), 0.0);
#endif
    bool all_sides = dot(surface.xyz, surface.xyz) < FACING * FACING * surface.a * surface.a;
    if (all_sides)
        return (front + back.rgb) * (0.31830989 / (surface.a + back.a));
    return (dot(surface.xyz, direction) < 0.0 ? front : back.rgb) * (0.31830989 / surface.a);
}
