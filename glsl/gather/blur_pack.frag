// Puts the interleaved tiles back into picture order, and each pixel's place, normal and light together.
#include "gather/blur_tap.glsl"
#include "lib/gbuffer.glsl"
#include "lib/interleaving.glsl"
#include "shared/blur.h"

layout(binding = UNIT_IRRADIANCE) uniform sampler2D source;

layout(location = TARGET_RESULT) out uvec4 packed_tap;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 normal_code = texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg;
    vec3 irradiance = texelFetch(source, interleaved_texel(params.pattern, pixel), 0).rgb;
    packed_tap = blur_tap_pack(blur_tap(gbuffer_depth(pixel), normal_code, irradiance));
}
