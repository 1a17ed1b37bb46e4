// The light that an occupied voxel's surfaces reflect, at its middle and by the mean normals of its sides: sums, as points
// add them up.
#include "passes/volume/irradiance.glsl"

layout(binding = UNIT_VOLUME_ALBEDO) uniform sampler2D albedos;

layout(location = 0) out vec4 front;
#if SPLIT
layout(binding = UNIT_VOLUME_TURNED_RADIOSITY) uniform sampler2D turned_radiosities;

layout(location = 1) out vec4 turned;
#else
layout(binding = UNIT_VOLUME_RADIOSITY) uniform sampler2D radiosities;
#endif
#if BACKS
layout(binding = UNIT_VOLUME_BACK) uniform sampler2D backs;

layout(location = 1 + SPLIT) out vec4 back;
#endif

// Of a side with that sum of normals.
vec3 arriving(vec3 place, vec3 normals) {
    vec3 irradiance;
    return volume_irradiance(place, normalize(normals + vec3(1e-6)), irradiance) ? irradiance : vec3(0.0);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(surfaces, texel, 0);
    vec3 place = vec3(volume_voxel(texel)) + 0.5, albedo = texelFetch(albedos, texel, 0).rgb, light = vec3(0.0);
    front = texelFetch(radiosities, texel, 0);
#if BACKS
    back = texelFetch(backs, texel, 0);
    if (back.a > 0.0)
        back.rgb += albedo * arriving(place, -surface.xyz) * (back.a / surface.a);
#endif
#if SPLIT
    turned = texelFetch(turned_radiosities, texel, 0);
    if (has_sides(surface)) {
        vec4 side = texelFetch(turned_surfaces, texel, 0), other = surface - side;
        vec3 of_side = albedo * arriving(place, side.xyz) * (side.a / surface.a);
        turned.rgb += of_side;
        front.rgb += of_side + albedo * arriving(place, other.xyz) * (other.a / surface.a);
        return;
    }
#endif
    if (surface.a > 0.0)
        front.rgb += albedo * arriving(place, surface.xyz);
}
