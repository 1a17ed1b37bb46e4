// What lies behind all surfaces, and between them and the camera.
#ifdef HAS_SKY
#include "lib/panorama.glsl"
#include "shared/composite.h"

layout(binding = UNIT_SKY) uniform sampler2D sky;

vec3 sky_radiance(ivec2 pixel) {
    vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(gbuffer_size()) - 1.0;
    vec3 along = camera.forward;
    if (!camera.orthographic)
        along += ndc.x * camera.right + ndc.y * camera.up;
    return params.sky_strength * panorama_texel(sky, along, params.sky_turn);
}

vec3 background(ivec2 pixel) {
    return params.sky_strength > 0.0 ? sky_radiance(pixel) : vec3(0.0);
}
#else
vec3 background(ivec2 pixel) {
    return vec3(0.0);
}
#endif

// Of light rays through smooth surfaces, in the medium.
#ifdef HAS_VOLUME_CAUSTICS
layout(binding = UNIT_VOLUME_CAUSTIC) uniform sampler2D volume_caustics;

vec3 volume_caustic(ivec2 texel) {
    return texelFetch(volume_caustics, texel, 0).rgb;
}
#else
vec3 volume_caustic(ivec2 texel) {
    return vec3(0.0);
}
#endif

// A medium on the way from surface to camera.
#ifdef HAS_MEDIUM
layout(binding = UNIT_IN_SCATTER) uniform sampler2D in_scatters;
layout(binding = UNIT_TRANSMITTANCE) uniform sampler2D transmittances;

vec3 airlight(ivec2 texel) {
    return params.scale * texelFetch(in_scatters, texel, 0).rgb;
}

vec3 through_medium(vec3 radiance, ivec2 texel) {
    return radiance * texelFetch(transmittances, texel, 0).rgb + airlight(texel) + volume_caustic(texel);
}
#else
vec3 airlight(ivec2 texel) {
    return vec3(0.0);
}

vec3 through_medium(vec3 radiance, ivec2 texel) {
    return radiance;
}
#endif
