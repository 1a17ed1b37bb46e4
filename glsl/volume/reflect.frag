// The light that an occupied voxel's surfaces reflect, at its middle and by its mean normal: sums, as points add them up.
#include "volume/irradiance.glsl"

layout(binding = UNIT_VOLUME_RADIOSITY) uniform sampler2D radiosities;
layout(binding = UNIT_VOLUME_ALBEDO) uniform sampler2D albedos;

layout(location = 0) out vec4 front;
#if BACKS
layout(binding = UNIT_VOLUME_BACK) uniform sampler2D backs;

layout(location = 1) out vec4 back;
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(surfaces, texel, 0);
    front = texelFetch(radiosities, texel, 0);
#if BACKS
    back = texelFetch(backs, texel, 0);
#endif
    if (surface.a == 0.0)
        return;
    vec3 place = vec3(volume_voxel(texel)) + 0.5, albedo = texelFetch(albedos, texel, 0).rgb, irradiance;
    vec3 normal = normalize(surface.xyz + vec3(1e-6));
    if (volume_irradiance(place, normal, irradiance))
        front.rgb += albedo * irradiance;
#if BACKS
    if (volume_irradiance(place, -normal, irradiance))
        back.rgb += albedo * irradiance * (back.a / surface.a);
#endif
}
