// Geometry-aware blur along one axis, or over a square at once [Dong 2009 §6; Laine et al. 2007]: neighbours count where they are
// near in space and normal. The ends have half weight, so that the window holds each place of the
// interleaving pattern equally and is not shifted by half a pixel.
#include "lib/surface.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    blur_params params;
};
layout(binding = 0) uniform sampler2DArray depths;
layout(binding = 1) uniform sampler2DArray normals;
layout(binding = 2) uniform sampler2D source;

layout(location = 0) out vec4 blurred;

// Where a pixel lies in a picture of interleaved tiles.
ivec2 source_texel(ivec2 pixel) {
    int n = int(params.interleave);
    ivec2 tile = pixel % n;
    return tile * ivec2(params.tile_width, params.tile_height) + pixel / n;
}

void main() {
    blurred = vec4(0.0);
    ivec2 pixel = ivec2(gl_FragCoord.xy), size = textureSize(depths, 0).xy;
    surface center = surface_fetch(camera, depths, normals, ivec3(pixel, 0));
    if (!center.present)
        return;
    int radius = int(params.radius), rows = int(params.radius_y);
    ivec2 along = ivec2(params.direction.xy), across = along.yx;
    vec4 sum = vec4(0.0);
    for (int j = -rows; j <= rows; j++)
        for (int i = -radius; i <= radius; i++) {
            ivec2 tap = pixel + i * along + j * across;
            if (any(lessThan(tap, ivec2(0))) || any(greaterThanEqual(tap, size)))
                continue;
            surface s = surface_fetch(camera, depths, normals, ivec3(tap, 0));
            vec3 apart = s.position - center.position;
            if (s.present && dot(apart, apart) < params.distance2 &&
                dot(s.normal, center.normal) > params.cosine) {
                float weight = (radius > 0 && abs(i) == radius ? 0.5 : 1.0) *
                               (rows > 0 && abs(j) == rows ? 0.5 : 1.0);
                sum += weight * vec4(texelFetch(source, source_texel(tap), 0).rgb, 1.0);
            }
        }
    blurred = vec4(sum.rgb / max(sum.a, 0.25), 1.0);
}
