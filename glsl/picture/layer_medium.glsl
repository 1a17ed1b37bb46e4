// What lies behind all surfaces, and between them and the camera.
#ifdef HAS_SKY
#include "picture/sky.glsl"

vec3 background(ivec2 pixel) {
    return params.sky_strength > 0.0 ? sky_radiance(pixel) : vec3(0.0);
}
#else
vec3 background(ivec2 pixel) {
    return vec3(0.0);
}
#endif

// What the technique adds on its way from surface to camera, if anything.
#ifdef HAS_MEDIUM
layout(binding = UNIT_IN_SCATTER) uniform sampler2D in_scatters;
layout(binding = UNIT_TRANSMITTANCE) uniform sampler2D transmittances;

vec3 through_medium(vec3 radiance, ivec2 texel) {
    return radiance * texelFetch(transmittances, texel, 0).rgb + params.scale * texelFetch(in_scatters, texel, 0).rgb;
}
#else
vec3 through_medium(vec3 radiance, ivec2 texel) {
    return radiance;
}
#endif
