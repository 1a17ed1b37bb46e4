// Geometry-aware blur along one axis, or over a square at once [Dong 2009 §6; Laine et al. 2007]:
// neighbours count where they are near in space and normal. The ends have half weight, so that the window
// holds each place of the interleaving pattern equally and is not shifted by half a pixel.
#include "lib/gbuffer.glsl"
#include "passes/gather/blur_tap.glsl"
#include "shared/gather.h"

PASS_BLOCK(blur_params, 96)

layout(binding = UNIT_BLUR_TAPS) uniform usampler2D taps;

#if PACK
layout(location = TARGET_RESULT) out uvec4 packed_tap;
#else
layout(location = TARGET_RESULT) out vec4 blurred;
#endif

// In the camera's own axes, metres.
vec3 tap_position(vec2 aside, float depth) {
    return vec3(aside * (camera.orthographic ? 1.0 : depth), depth);
}

void write(uvec4 center, vec3 irradiance) {
#if PACK
    packed_tap = blur_tap_lit(center, irradiance);
#else
#if SPECULAR_BLUR
    irradiance *= pixel_reflects(ivec2(gl_FragCoord.xy));
#endif
    blurred = vec4(irradiance, blur_tap_depth(center) > 0.0 ? 1.0 : 0.0);
#endif
}

// Of a tap so many pixels away: half of one at the end.
float window(int away, float radius) {
    return clamp(radius - float(away) + 0.5, 0.0, 1.0);
}

float of_level(vec4 values, int level) {
    vec2 pair = level < 2 ? values.xy : values.zw;
    return (level & 1) == 0 ? pair.x : pair.y;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), size = textureSize(taps, 0);
    // A pixel's place in the picture's plane, a metre away.
    vec2 extent = vec2(length(camera.right), length(camera.up)), per_pixel = 2.0 / vec2(size) * extent;
    vec3 lean = camera.forward - view_axis(camera); // of a shifted lens
    vec2 corner = extent - vec2(dot(lean, camera.right), dot(lean, camera.up)) / extent;
    uvec4 center = texelFetch(taps, pixel, 0);
    float depth = blur_tap_depth(center);
    vec3 position = tap_position((vec2(pixel) + 0.5) * per_pixel - corner, depth), normal = blur_tap_normal(center);
    normal /= dot(normal, normal); // rounded, it still is like itself
    float reach = params.distance * 2.0 * extent.y * (camera.orthographic ? 1.0 : depth);
    int radius = params.radius, rows = params.rows;
    // Two pixels count for each other between what each counts for its like, so that as much light goes as comes.
    // Pixels of lists take of none beyond their own windows.
    int level = blur_tap_level(center);
    float like = level == BLUR_LEVEL_OF_LIST(PIXEL_LEVEL_DETAIL) ? params.detail_cosine : params.cosine;
    vec4 radii = level == BLUR_LEVEL_NONE ? params.taken_radii : min(params.radii, of_level(params.radii, level));
    vec4 weights = sqrt(params.weights * of_level(params.weights, level));
    ivec2 along = params.along, across = along.yx;
    vec4 sum = vec4(0.0);
    // No branches: a software rasteriser executes both sides, and keeps books of which pixel is where.
    for (int j = -rows; j <= rows; j++)
        for (int i = -radius; i <= radius; i++) {
            ivec2 at = pixel + i * along + j * across;
            ivec2 inside = clamp(at, ivec2(0), size - 1);
            uvec4 tap = texelFetch(taps, inside, 0);
            float tap_depth = blur_tap_depth(tap);
            vec3 apart = tap_position((vec2(at) + 0.5) * per_pixel - corner, tap_depth) - position;
            bool alike = at == inside && tap_depth > 0.0 && dot(apart, apart) < reach * reach &&
                dot(blur_tap_normal(tap), normal) > like;
            int tap_level = blur_tap_level(tap);
            float wide = of_level(radii, tap_level);
            float weight = window(abs(i), wide) * (rows > 0 ? window(abs(j), wide) : 1.0) * of_level(weights, tap_level);
            sum += (alike ? weight : 0.0) * vec4(blur_tap_irradiance(tap), 1.0);
        }
    write(center, depth > 0.0 ? sum.rgb / max(sum.a, 0.25) : vec3(0.0));
}
