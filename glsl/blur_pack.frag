// Puts the interleaved tiles back into picture order, and each pixel's place, normal and light together.
#include "lib/blur_tap.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    blur_params params;
};
layout(binding = UNIT_GBUFFER_DEPTH) uniform sampler2DArray depths;
layout(binding = UNIT_GBUFFER_NORMAL) uniform sampler2DArray normals;
layout(binding = UNIT_INDIRECT) uniform sampler2D source;

layout(location = TARGET_RESULT) out uvec4 packed_tap;

// Where a pixel lies in a picture of interleaved tiles.
ivec2 source_texel(ivec2 pixel) {
    int n = int(params.interleave);
    ivec2 tile = pixel % n;
    return tile * ivec2(params.tile_width, params.tile_height) + pixel / n;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depths, ivec3(pixel, 0), 0).r;
    vec2 normal_code = texelFetch(normals, ivec3(pixel, 0), 0).rg;
    vec3 irradiance = texelFetch(source, source_texel(pixel), 0).rgb;
    packed_tap = blur_tap_pack(blur_tap(depth, normal_code, irradiance));
}
