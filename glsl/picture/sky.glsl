// What is seen of the scene's environment.
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
