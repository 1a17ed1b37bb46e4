// What is seen of the scene's environment, a panorama whose texels are even patches: the same as
// scene/lights/environment.c.
#include "shared/composite.h"

layout(binding = UNIT_SKY) uniform sampler2D sky;

vec3 sky_radiance(ivec2 pixel) {
    const float PI = 3.14159265;
    vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(gbuffer_size()) - 1.0;
    vec3 along = camera.forward;
    if (!camera.orthographic)
        along += ndc.x * camera.right + ndc.y * camera.up;
    float azimuth = atan(along.z, along.x) + params.sky_turn;
    vec2 place = vec2(fract(azimuth / (2.0 * PI) + 0.5), atan(length(along.xz), along.y) / PI);
    ivec2 size = textureSize(sky, 0);
    return params.sky_strength * texelFetch(sky, min(ivec2(place * vec2(size)), size - 1), 0).rgb;
}
